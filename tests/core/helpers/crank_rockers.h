#pragma once

#include <cmath>

#include "sketch/sketch.h"

// Header only, of the sketch's level.

namespace liftarm::testing {

//! \brief A crank of 2, a coupler of 6, a rocker of 5 on pivots 6 apart in the XZ plane, the crank
//! upright: lines 1, 2, 3 and 0. \param range What the crank must do, if anything.
inline sketch::Sketch crankRocker(std::optional<std::array<double, 2>> range) {
  using lattice::Vec3;
  const Vec3 crank{0, 0, 2};
  const double far = std::sqrt(40.0);
  const double along = (36.0 - 25.0 + 40.0) / (2.0 * far);
  const double across = std::sqrt(36.0 - along * along);
  const Vec3 way = lattice::normalized(Vec3{6, 0, -2});
  const Vec3 rocker = crank + along * way + across * Vec3{-way.z, 0, way.x};
  sketch::Sketch sketch;
  sketch.name = "crank-rocker";
  const auto add = [&](Vec3 from, Vec3 to) {
    sketch::Line line;
    line.from = from;
    line.to = to;
    line.length = static_cast<int>(std::lround(lattice::length(to - from)));
    sketch.lines.push_back(line);
  };
  add({0, 0, 0}, {6, 0, 0});
  add({0, 0, 0}, crank);
  add(crank, rocker);
  add({6, 0, 0}, rocker);
  const auto joint = [&](Vec3 at, int a, int b) {
    sketch::Joint added;
    added.at = at;
    added.axis = {0, 1, 0};
    added.between = {{a}, {b}};
    sketch.joints.push_back(added);
  };
  joint({0, 0, 0}, 0, 1);
  joint(crank, 1, 2);
  joint(rocker, 2, 3);
  joint({6, 0, 0}, 0, 3);
  sketch.joints.front().range = range;
  return sketch;
}

}  // namespace liftarm::testing
