#include "objective/place_index.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace liftarm::objective {

namespace {

using lattice::Axis;
using lattice::Vec3;

constexpr std::size_t kBuckets = 4096;  // a power of two
constexpr double kPerModule = 4.0;
constexpr double kSame = 1e-3;  // modules

std::size_t bucketOf(int axis, const std::array<std::int64_t, 3>& cell) {
  std::uint64_t hash = static_cast<std::uint64_t>(axis) + 1U;
  for (const std::int64_t k : cell) {
    hash = (hash ^ static_cast<std::uint64_t>(k)) * 0x9E3779B97F4A7C15ULL;
    hash ^= hash >> 29U;
  }
  return static_cast<std::size_t>(hash & (kBuckets - 1U));
}

std::int64_t cellOf(double x) {
  return static_cast<std::int64_t>(std::floor(x * kPerModule + 0.5));
}

bool same(Vec3 a, Vec3 b) {
  const Vec3 d = a - b;
  return std::abs(d.x) < kSame && std::abs(d.y) < kSame && std::abs(d.z) < kSame;
}

}  // namespace

PlaceIndex::PlaceIndex() : heads_(kBuckets, -1) {}

void PlaceIndex::clear() {
  entries_.clear();
  heads_.assign(kBuckets, -1);
}

void PlaceIndex::add(Axis axis, Vec3 place, int value) {
  const int k = lattice::index(axis);
  const std::size_t bucket = bucketOf(k, {cellOf(place.x), cellOf(place.y), cellOf(place.z)});
  std::int32_t* end = &heads_[bucket];
  while (*end >= 0) {
    end = &entries_[static_cast<std::size_t>(*end)].next;
  }
  *end = static_cast<std::int32_t>(entries_.size());
  entries_.push_back({place, k, value, -1});
}

int PlaceIndex::find(Axis axis, Vec3 place) const {
  const int k = lattice::index(axis);
  std::array<std::array<std::int64_t, 2>, 3> cells{};
  for (int i = 0; i < 3; ++i) {
    cells[static_cast<std::size_t>(i)] = {cellOf(place[i] - kSame), cellOf(place[i] + kSame)};
  }
  for (unsigned corner = 0; corner < 8U; ++corner) {
    std::array<std::int64_t, 3> cell{};
    bool repeated = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const unsigned side = corner >> static_cast<unsigned>(i) & 1U;
      cell[i] = cells[i][side];
      repeated = repeated || (side == 1U && cells[i][0] == cells[i][1]);
    }
    if (repeated) {
      continue;
    }
    for (std::int32_t e = heads_[bucketOf(k, cell)]; e >= 0;) {
      const Entry& entry = entries_[static_cast<std::size_t>(e)];
      if (entry.axis == k && same(entry.place, place)) {
        return entry.value;
      }
      e = entry.next;
    }
  }
  return -1;
}

}  // namespace liftarm::objective
