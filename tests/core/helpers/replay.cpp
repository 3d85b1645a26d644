#include "core/helpers/replay.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace liftarm::testing {

namespace {

using lattice::Vec3;

constexpr double kStep = 0.125;
constexpr double kStepAway = 0.25;
constexpr int kEvery = 5;  // one in so many cubes of the surface

//! Middles of every fifth cube that has a free side, part frame.
std::vector<Vec3> surfaceOf(const VoxelSolid& solid) {
  std::vector<Vec3> points;
  for (int z = 0; z < solid.nz; ++z) {
    for (int y = 0; y < solid.ny; ++y) {
      for (int x = 0; x < solid.nx; ++x) {
        if ((x + 2 * y + 3 * z) % kEvery != 0 || !solid.at(x, y, z)) {
          continue;
        }
        const bool inside = solid.at(x - 1, y, z) && solid.at(x + 1, y, z) &&
                            solid.at(x, y - 1, z) && solid.at(x, y + 1, z) &&
                            solid.at(x, y, z - 1) && solid.at(x, y, z + 1);
        if (!inside) {
          points.push_back({kCube * (x + solid.ox + 0.5),
                            kCube * (z + solid.oz + 0.5),
                            -kCube * (y + solid.oy + 0.5)});
        }
      }
    }
  }
  return points;
}

Vec3 toPart(const lattice::Pose& pose, Vec3 world) {
  return lattice::transposed(pose.rotation) * (world - pose.position);
}

bool within(Vec3 p, Vec3 min, Vec3 max) {
  return p.x >= min.x && p.y >= min.y && p.z >= min.z && p.x <= max.x && p.y <= max.y &&
         p.z <= max.z;
}

std::string placeText(Vec3 p) {
  return std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z);
}

}  // namespace

Replay::Replay(const model::Model& model) : model_(model) {
  std::map<std::string, std::vector<Vec3>> surfaces;
  for (const model::PlacedPart& part : model.parts) {
    Placed placed;
    placed.solid = solids_.find(part.part);
    if (placed.solid != nullptr) {
      const auto [known, isNew] = surfaces.try_emplace(part.part);
      if (isNew) {
        known->second = surfaceOf(*placed.solid);
      }
      for (const Vec3 p : known->second) {
        placed.surface.push_back(part.pose.apply(p));
        for (int i = 0; i < 3; ++i) {
          placed.box.min[i] = std::min(placed.box.min[i], placed.surface.back()[i]);
          placed.box.max[i] = std::max(placed.box.max[i], placed.surface.back()[i]);
        }
      }
    }
    placed_.push_back(std::move(placed));
  }
}

bool Replay::near(int mover, int fixed, Vec3 by) const {
  const Bounds& a = placed_[static_cast<std::size_t>(mover)].box;
  const Bounds& b = placed_[static_cast<std::size_t>(fixed)].box;
  for (int i = 0; i < 3; ++i) {
    if (a.max[i] + by[i] < b.min[i] || b.max[i] < a.min[i] + by[i]) {
      return false;
    }
  }
  return true;
}

bool Replay::meet(int mover, int fixed, Vec3 by) const {
  const Placed& a = placed_[static_cast<std::size_t>(mover)];
  const Placed& b = placed_[static_cast<std::size_t>(fixed)];
  const lattice::Pose& poseA = model_.parts[static_cast<std::size_t>(mover)].pose;
  const lattice::Pose& poseB = model_.parts[static_cast<std::size_t>(fixed)].pose;
  return std::any_of(a.surface.begin(),
                     a.surface.end(),
                     [&](Vec3 p) {
                       return within(p + by, b.box.min, b.box.max) &&
                              b.solid->contains(toPart(poseB, p + by));
                     }) ||
         std::any_of(b.surface.begin(), b.surface.end(), [&](Vec3 p) {
           return within(p - by, a.box.min, a.box.max) && a.solid->contains(toPart(poseA, p - by));
         });
}

std::vector<std::string> Replay::playMove(const ReplayMove& move,
                                          const std::vector<int>& rest) const {
  std::vector<std::string> found;
  // True while something is still beside a moved part; tells of what it meets once.
  const auto look = [&](Vec3 by) {
    for (const int part : move.parts) {
      for (const int other : rest) {
        if (found.empty() && near(part, other, by) && meet(part, other, by)) {
          found.push_back("part " + std::to_string(part) + " hits part " + std::to_string(other) +
                          " when moved by " + placeText(by));
        }
      }
    }
  };
  Vec3 at;
  for (const Vec3 leg : move.legs) {
    const double length = lattice::length(leg);
    const int steps = static_cast<int>(std::ceil(length / kStep));
    for (int i = 1; i <= steps && found.empty(); ++i) {
      look(at + (static_cast<double>(i) / steps) * leg);
    }
    at = at + leg;
  }
  const Vec3 away = kStepAway * lattice::normalized(move.legs.back());
  constexpr int kFar = 4 * 80;  // steps: further than any model of the tests is wide
  for (int i = 1; i <= kFar && found.empty(); ++i) {
    look(at + static_cast<double>(i) * away);
  }
  return found;
}

std::vector<std::string> Replay::play(const std::vector<int>& together,
                                      const std::vector<ReplayMove>& moves) {
  std::vector<std::string> found;
  std::vector<int> rest = together;
  for (const ReplayMove& move : moves) {
    for (const int part : move.parts) {
      rest.erase(std::remove(rest.begin(), rest.end(), part), rest.end());
    }
    if (move.legs.empty()) {
      continue;
    }
    const std::vector<std::string> met = playMove(move, rest);
    found.insert(found.end(), met.begin(), met.end());
  }
  return found;
}

}  // namespace liftarm::testing
