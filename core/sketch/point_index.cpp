#include "sketch/point_index.h"

#include <cmath>

#include "base/check.h"
#include "base/hash.h"

namespace liftarm::sketch {

namespace {

// Cells are wider than the tolerance so that most look-ups stay in one cell. They are shifted
// because most points are whole numbers, which would otherwise all lie on the borders of cells.
constexpr double kCellsPerTolerance = 8.0;
constexpr double kShift = 0.4;

std::uint64_t keyOf(std::int64_t x, std::int64_t y, std::int64_t z) {
  const std::uint64_t first = base::mixHash(0, static_cast<std::uint64_t>(x));
  const std::uint64_t second = base::mixHash(first, static_cast<std::uint64_t>(y));
  return base::mixHash(second, static_cast<std::uint64_t>(z));
}

}  // namespace

PointIndex::PointIndex(double tolerance)
    : tolerance_(tolerance), cellSize_(kCellsPerTolerance * tolerance) {
  LIFTARM_CHECK(tolerance > 0.0, "the tolerance of a point index is positive");
}

std::int64_t PointIndex::cellOf(double coordinate) const {
  return static_cast<std::int64_t>(std::floor(coordinate / cellSize_ + kShift));
}

void PointIndex::searchCell(std::uint64_t key, lattice::Vec3 point, Nearest& nearest) const {
  const auto cell = firstInCell_.find(key);
  int id = cell == firstInCell_.end() ? -1 : cell->second;
  for (; id >= 0; id = nextInCell_[static_cast<std::size_t>(id)]) {
    const double distance = lattice::length(at(id) - point);
    const bool isFirst = nearest.id < 0 || id < nearest.id;
    if (distance < nearest.distance || (distance == nearest.distance && isFirst)) {
      nearest = {id, distance};
    }
  }
}

int PointIndex::find(lattice::Vec3 point) const {
  const lattice::Vec3 reach{tolerance_, tolerance_, tolerance_};
  const lattice::Vec3 low = point - reach;
  const lattice::Vec3 high = point + reach;
  Nearest nearest{-1, tolerance_};
  for (std::int64_t x = cellOf(low.x); x <= cellOf(high.x); ++x) {
    for (std::int64_t y = cellOf(low.y); y <= cellOf(high.y); ++y) {
      for (std::int64_t z = cellOf(low.z); z <= cellOf(high.z); ++z) {
        searchCell(keyOf(x, y, z), point, nearest);
      }
    }
  }
  return nearest.id;
}

int PointIndex::insert(lattice::Vec3 point) {
  const int id = size();
  points_.push_back(point);
  const std::uint64_t key = keyOf(cellOf(point.x), cellOf(point.y), cellOf(point.z));
  const auto [cell, isNew] = firstInCell_.try_emplace(key, id);
  nextInCell_.push_back(isNew ? -1 : cell->second);
  cell->second = id;
  return id;
}

int PointIndex::findOrInsert(lattice::Vec3 point) {
  const int found = find(point);
  return found >= 0 ? found : insert(point);
}

}  // namespace liftarm::sketch
