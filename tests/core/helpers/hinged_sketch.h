#pragma once

#include <cstdint>
#include <utility>

#include "base/rng.h"
#include "sketch/sketch.h"

namespace liftarm::testing {

//! \brief Two lines that share a hinge at the origin, with arms that stand off them in the way.
inline sketch::Sketch hingedSketch(std::uint64_t seed) {
  base::Rng rng(seed);
  const auto below = [&](int n) {
    return static_cast<int>(rng.below(static_cast<std::uint32_t>(n)));
  };
  const lattice::Vec3 unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const int k = below(3);
  const lattice::Vec3 axis = unit[k];
  const lattice::Vec3 side = unit[(k + 1) % 3];
  const lattice::Vec3 other = unit[(k + 2) % 3];
  constexpr std::pair<double, double> kTurns[] = {
      {0, 1}, {-1, 0}, {0.6, 0.8}, {-0.6, 0.8}, {0.8, -0.6}};
  const auto [c, s] = kTurns[below(5)];
  const lattice::Vec3 directions[] = {side, c * side + s * other};
  sketch::Sketch result;
  result.name = "hinged";
  const auto addLine = [&](lattice::Vec3 from, lattice::Vec3 to) {
    result.lines.emplace_back();
    result.lines.back().from = from;
    result.lines.back().to = to;
  };
  for (const lattice::Vec3 direction : directions) {
    // Lines along each other end at the hinge: what lies on each other cannot turn.
    const double back = c == -1.0 ? 0 : below(3);
    const double front = 5.0 * (1 + below(2));
    addLine(-back * direction, front * direction);
  }
  for (const lattice::Vec3 direction : directions) {
    for (int arm = below(3); arm > 0; --arm) {
      const lattice::Vec3 foot = static_cast<double>(2 + below(4)) * direction;
      const double length = (2 + below(4)) * (below(2) == 0 ? 1 : -1);
      addLine(foot, foot + length * axis);
    }
  }
  result.joints.push_back({{}, axis, {{0}, {1}}});
  return result;
}

}  // namespace liftarm::testing
