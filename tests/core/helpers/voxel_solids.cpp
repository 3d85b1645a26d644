#include "core/helpers/voxel_solids.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include <nlohmann/json.hpp>

#include "core/helpers/lzma2.h"
#include "core/helpers/shared_data.h"

namespace liftarm::testing {

namespace {

using lattice::Vec3;

//! Ours to cubes of LDraw's frame: (x, y, z)LDraw = (x, -z, y)ours.
Vec3 toCubes(Vec3 p) {
  return {p.x / kCube, -p.z / kCube, p.y / kCube};
}

std::span<const std::uint8_t> bytes(const std::string& text,
                                    std::size_t offset,
                                    std::size_t length) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()) + offset, length};
}

struct Box {
  Vec3 min{1e9, 1e9, 1e9};
  Vec3 max{-1e9, -1e9, -1e9};

  void add(Vec3 p) {
    for (int i = 0; i < 3; ++i) {
      min[i] = std::min(min[i], p[i]);
      max[i] = std::max(max[i], p[i]);
    }
  }

  [[nodiscard]] bool contains(Vec3 p) const {
    return p.x >= min.x && p.y >= min.y && p.z >= min.z && p.x <= max.x && p.y <= max.y &&
           p.z <= max.z;
  }
};

bool meet(const Box& a, const Box& b) {
  for (int i = 0; i < 3; ++i) {
    if (a.max[i] < b.min[i] || b.max[i] < a.min[i]) {
      return false;
    }
  }
  return true;
}

Vec3 toPart(const lattice::Pose& pose, Vec3 world) {
  return lattice::transposed(pose.rotation) * (world - pose.position);
}

struct PlacedSolid {
  const VoxelSolid* solid = nullptr;
  std::vector<Vec3> points;  // world
  Box box;
};

}  // namespace

bool VoxelSolid::at(int x, int y, int z) const {
  if (x < 0 || y < 0 || z < 0 || x >= nx || y >= ny || z >= nz) {
    return false;
  }
  const auto i = static_cast<std::size_t>(x + nx * (y + ny * z));
  return ((static_cast<unsigned>(bits[i / 8]) >> (i % 8)) & 1U) != 0;
}

bool VoxelSolid::contains(Vec3 p) const {
  const Vec3 c = toCubes(p);
  return at(static_cast<int>(std::floor(c.x)) - ox,
            static_cast<int>(std::floor(c.y)) - oy,
            static_cast<int>(std::floor(c.z)) - oz);
}

std::vector<Vec3> VoxelSolid::points() const {
  std::vector<Vec3> result;
  for (int z = 0; z < nz; ++z) {
    for (int y = 0; y < ny; ++y) {
      for (int x = 0; x < nx; ++x) {
        if (at(x, y, z)) {
          result.push_back(
              {kCube * (x + ox + 0.5), kCube * (z + oz + 0.5), -kCube * (y + oy + 0.5)});
        }
      }
    }
  }
  return result;
}

VoxelSolids::VoxelSolids() {
  file_ = readSharedFile("solids/parts.pack").value_or("");
  if (file_.size() < 4) {
    return;
  }
  const auto head = bytes(file_, 0, 4);
  const std::size_t size = head[0] + (head[1] << 8U) + (head[2] << 16U);
  const std::vector<std::uint8_t> index = unpackXz(bytes(file_, 4, size));
  const auto document = nlohmann::json::parse(index.begin(), index.end(), nullptr, false);
  dataAt_ = 4 + size;
  for (const auto& [id, row] : document.items()) {
    Entry entry;
    entry.shape = {row[0], row[1], row[2], row[3], row[4], row[5], {}};
    entry.offset = row[6];
    entry.length = row[7];
    entries_.emplace(id, std::move(entry));
  }
}

const VoxelSolid* VoxelSolids::find(const std::string& part) {
  const auto it = entries_.find(part);
  if (it == entries_.end()) {
    return nullptr;
  }
  Entry& entry = it->second;
  if (!entry.unpacked) {
    const int cubes = entry.shape.nx * entry.shape.ny * entry.shape.nz;
    const std::size_t size = (static_cast<std::size_t>(cubes) + 7) / 8;
    entry.shape.bits = unpackLzma2(bytes(file_, dataAt_ + entry.offset, entry.length), size);
    entry.shape.bits.resize(size);
    entry.unpacked = true;
  }
  return &entry.shape;
}

std::vector<VoxelOverlap> voxelOverlaps(const model::Model& model, VoxelSolids& solids) {
  std::vector<PlacedSolid> placed(model.parts.size());
  for (std::size_t i = 0; i < placed.size(); ++i) {
    placed[i].solid = solids.find(model.parts[i].part);
    if (placed[i].solid == nullptr) {
      continue;
    }
    for (const Vec3 p : placed[i].solid->points()) {
      placed[i].points.push_back(model.parts[i].pose.apply(p));
      placed[i].box.add(placed[i].points.back());
    }
  }
  std::vector<VoxelOverlap> overlaps;
  for (std::size_t a = 0; a < placed.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (!meet(placed[a].box, placed[b].box)) {
        continue;
      }
      VoxelOverlap overlap{static_cast<int>(a), static_cast<int>(b), 0, {}};
      for (const Vec3 p : placed[a].points) {
        if (placed[b].box.contains(p) &&
            placed[b].solid->contains(toPart(model.parts[b].pose, p))) {
          ++overlap.cubes;
          overlap.at = p;
        }
      }
      if (overlap.cubes > 0) {
        overlaps.push_back(overlap);
      }
    }
  }
  return overlaps;
}

}  // namespace liftarm::testing
