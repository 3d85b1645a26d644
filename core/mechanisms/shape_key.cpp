#include "mechanisms/shape_key.h"

#include <algorithm>
#include <array>
#include <set>

namespace liftarm::mechanisms {

namespace {

using lattice::Axis;
using lattice::Cell;

//! A lattice rotation in whole numbers.
struct Turn {
  std::array<int, 3> from{};  // component i of a turned cell is sign[i] times component from[i]
  std::array<int, 3> sign{};

  [[nodiscard]] Cell of(Cell cell) const {
    Cell result;
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      result[i] = sign[k] * cell[from[k]];
    }
    return result;
  }

  [[nodiscard]] int axisOf(Axis axis) const {
    return static_cast<int>(std::find(from.begin(), from.end(), lattice::index(axis)) -
                            from.begin());
  }
};

const std::vector<Turn>& turns() {
  static const std::vector<Turn> kTurns = [] {
    std::vector<Turn> all;
    for (const lattice::Mat3& rotation : lattice::latticeRotations()) {
      Turn turn;
      for (int i = 0; i < 3; ++i) {
        const lattice::Vec3 image = rotation * lattice::unitVector(lattice::axisFromIndex(i));
        for (int k = 0; k < 3; ++k) {
          if (image[k] != 0.0) {
            turn.from[static_cast<std::size_t>(k)] = i;
            turn.sign[static_cast<std::size_t>(k)] = image[k] > 0.0 ? 1 : -1;
          }
        }
      }
      all.push_back(turn);
    }
    return all;
  }();
  return kTurns;
}

ShapeKey keyOf(const Mechanism& mechanism, const Turn& turn) {
  constexpr std::uint32_t kWidth = 64;  // of a mechanism, at most, and of all roles
  std::vector<Cell> places;
  places.reserve(mechanism.cells.size());
  Cell base{1 << 20, 1 << 20, 1 << 20};
  for (const MechanismCell& cell : mechanism.cells) {
    places.push_back(turn.of(cell.at));
    for (int i = 0; i < 3; ++i) {
      base[i] = std::min(base[i], places.back()[i]);
    }
  }
  ShapeKey key;
  key.reserve(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const MechanismCell& cell = mechanism.cells[i];
    const Cell at = places[i] - base;
    const int role = cell.head ? 1 + static_cast<int>(cell.kind)
                               : (cell.openHole ? 7 + static_cast<int>(cell.kind) : 0);
    const int axis = role == 0 ? 0 : turn.axisOf(cell.axis);
    const Cell collar = turn.of(cell.collar);
    const int end = collar.x + collar.y + collar.z;  // one of them, 1 or -1, or none
    std::uint32_t code = 0;
    for (const int part : {at.x, at.y, at.z}) {
      code = code * kWidth + static_cast<std::uint32_t>(part);
    }
    code = code * 16 + static_cast<std::uint32_t>(role);
    key.push_back(code * 9 + static_cast<std::uint32_t>(axis + 3 * (end + 1)));
  }
  std::sort(key.begin(), key.end());
  return key;
}

}  // namespace

ShapeKey canonicalKey(const Mechanism& mechanism) {
  ShapeKey best;
  for (const Turn& turn : turns()) {
    ShapeKey key = keyOf(mechanism, turn);
    if (best.empty() || key < best) {
      best = std::move(key);
    }
  }
  return best;
}

std::vector<Mechanism> turnedWays(const Mechanism& mechanism) {
  std::set<ShapeKey> seen;
  std::vector<Mechanism> ways;
  for (std::size_t r = 0; r < turns().size(); ++r) {
    if (seen.insert(keyOf(mechanism, turns()[r])).second) {
      ways.push_back(rotated(mechanism, lattice::latticeRotations()[r]));
    }
  }
  return ways;
}

}  // namespace liftarm::mechanisms
