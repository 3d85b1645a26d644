#include "gears/line_nodes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace liftarm::gears {

namespace {

using lattice::Cell;
using lattice::Vec3;

constexpr double kOnLattice = 1e-3;  // modules
constexpr double kWidth = 0.9;       // of a part: nearer than this two axes do not pass each other

Vec3 directionOf(const sketch::Line& line) {
  return (1.0 / static_cast<double>(line.length)) * (line.to - line.from);
}

std::optional<Cell> cellOf(Vec3 p) {
  Cell cell;
  for (int k = 0; k < 3; ++k) {
    cell[k] = static_cast<int>(std::lround(p[k]));
  }
  return lattice::length(p - lattice::toVec3(cell)) <= kOnLattice ? std::optional(cell)
                                                                  : std::nullopt;
}

}  // namespace

LineNodes::LineNodes(const sketch::Sketch& sketch) : sketch_(sketch) {
  for (std::size_t i = 0; i < sketch.lines.size(); ++i) {
    const sketch::Line& line = sketch.lines[i];
    for (int n = 0; n <= line.length; ++n) {
      const Vec3 node = line.from + static_cast<double>(n) * directionOf(line);
      nodes_.push_back(node);
      if (const std::optional<Cell> cell = cellOf(node)) {
        onLattice_[*cell].push_back(static_cast<int>(i));
      }
    }
  }
}

std::vector<int> LineNodes::at(Cell cell) const {
  const auto found = onLattice_.find(cell);
  return found == onLattice_.end() ? std::vector<int>{} : found->second;
}

std::optional<int> LineNodes::bearingAt(Cell cell, int axis) const {
  const std::vector<int> lines = at(cell);
  if (lines.size() != 1) {
    return std::nullopt;
  }
  const sketch::Line& line = sketch_.lines[static_cast<std::size_t>(lines.front())];
  const bool across = std::abs(directionOf(line)[axis]) <= kOnLattice;
  const bool free = !line.holeAxis.has_value() || lattice::index(*line.holeAxis) == axis;
  return across && free ? std::optional(lines.front()) : std::nullopt;
}

std::optional<int> LineNodes::passing(Cell cell) const {
  for (std::size_t i = 0; i < sketch_.lines.size(); ++i) {
    const sketch::Line& line = sketch_.lines[i];
    const Vec3 along = directionOf(line);
    const Vec3 offset = lattice::toVec3(cell) - line.from;
    const double place =
        std::clamp(lattice::dot(offset, along), 0.0, static_cast<double>(line.length));
    const double off = lattice::length(offset - place * along);
    const bool node = off <= kOnLattice && std::abs(place - std::round(place)) <= kOnLattice;
    if (off < kWidth && !node) {
      return static_cast<int>(i);
    }
  }
  return std::nullopt;
}

}  // namespace liftarm::gears
