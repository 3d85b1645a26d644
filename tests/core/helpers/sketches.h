#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "guide/guiding_graph.h"
#include "sketch/sketch.h"

// Header only: tests of every level from guide on use it, and link no more than their own level.

namespace liftarm::testing {

using Segments = std::vector<std::pair<lattice::Vec3, lattice::Vec3>>;

//! \brief A sketch of these lines. \pre whole lengths.
inline sketch::Sketch sketchFrom(const Segments& lines) {
  sketch::Sketch sketch;
  sketch.name = "test";
  for (const auto& [from, to] : lines) {
    sketch::Line line;
    line.from = from;
    line.to = to;
    line.length = static_cast<int>(lattice::length(to - from) + 0.5);
    sketch.lines.push_back(line);
  }
  return sketch;
}

//! \brief One line along x.
inline sketch::Sketch lineSketch(double edges) {
  return sketchFrom({{{0, 0, 0}, {edges, 0, 0}}});
}

//! \brief A closed square in the XY plane.
inline sketch::Sketch squareSketch(double side) {
  return sketchFrom({{{0, 0, 0}, {side, 0, 0}},
                     {{side, 0, 0}, {side, side, 0}},
                     {{side, side, 0}, {0, side, 0}},
                     {{0, side, 0}, {0, 0, 0}}});
}

//! \brief Three lines that leave the origin along x, y and z.
inline sketch::Sketch cornerSketch(double length) {
  return sketchFrom(
      {{{0, 0, 0}, {length, 0, 0}}, {{0, 0, 0}, {0, length, 0}}, {{0, 0, 0}, {0, 0, length}}});
}

//! \brief A bar along x with a stem along y at its middle.
inline sketch::Sketch teeSketch() {
  return sketchFrom({{{-4, 0, 0}, {4, 0, 0}}, {{0, 0, 0}, {0, 6, 0}}});
}

//! \brief The twelve edges of a cube.
inline sketch::Sketch cubeSketch(double side) {
  Segments lines;
  for (int axis = 0; axis < 3; ++axis) {
    for (int corner = 0; corner < 4; ++corner) {
      lattice::Vec3 from;
      from[(axis + 1) % 3] = corner % 2 == 0 ? 0.0 : side;
      from[(axis + 2) % 3] = corner / 2 == 0 ? 0.0 : side;
      lattice::Vec3 to = from;
      to[axis] = side;
      lines.emplace_back(from, to);
    }
  }
  return sketchFrom(lines);
}

//! \brief A right triangle of 3, 4 and 5 modules times `scale`, its long side off the lattice.
inline sketch::Sketch triangleSketch(double scale) {
  return sketchFrom({{{0, 0, 0}, {4 * scale, 0, 0}},
                     {{0, 0, 0}, {0, 3 * scale, 0}},
                     {{4 * scale, 0, 0}, {0, 3 * scale, 0}}});
}

//! \brief n x n squares of `cell` modules in the XY plane (the paper's grid puzzle).
inline sketch::Sketch gridSketch(int n, double cell = 4.0) {
  Segments lines;
  const double side = cell * n;
  for (int i = 0; i <= n; ++i) {
    const double at = cell * i;
    lines.push_back({{0, at, 0}, {side, at, 0}});
    lines.push_back({{at, 0, 0}, {at, side, 0}});
  }
  return sketchFrom(lines);
}

//! \brief A box with a ridge on 3-4-5 rafters.
inline sketch::Sketch houseSketch() {
  const sketch::Sketch roof = sketchFrom({{{0, 0, 6}, {4, 0, 9}},
                                          {{8, 0, 6}, {4, 0, 9}},
                                          {{0, 8, 6}, {4, 8, 9}},
                                          {{8, 8, 6}, {4, 8, 9}},
                                          {{4, 0, 9}, {4, 8, 9}}});
  Segments lines;
  for (const double z : {0.0, 6.0}) {
    lines.push_back({{0, 0, z}, {8, 0, z}});
    lines.push_back({{8, 0, z}, {8, 8, z}});
    lines.push_back({{8, 8, z}, {0, 8, z}});
    lines.push_back({{0, 8, z}, {0, 0, z}});
  }
  for (const double x : {0.0, 8.0}) {
    lines.push_back({{x, 0, 0}, {x, 0, 6}});
    lines.push_back({{x, 8, 0}, {x, 8, 6}});
  }
  sketch::Sketch house = sketchFrom(lines);
  house.lines.insert(house.lines.end(), roof.lines.begin(), roof.lines.end());
  return house;
}

//! \brief A foot with a beam that turns about y on top of it.
inline sketch::Sketch seesawSketch() {
  sketch::Sketch sketch =
      sketchFrom({{{-4, 0, 0}, {4, 0, 0}}, {{0, 0, 0}, {0, 0, 6}}, {{-8, 0, 6}, {8, 0, 6}}});
  sketch.joints.push_back({{0, 0, 6}, {0, 1, 0}, {{1}, {2}}});
  return sketch;
}

inline guide::GuidingGraph graphOf(const sketch::Sketch& sketch) {
  return guide::buildGuidingGraph(sketch);
}

}  // namespace liftarm::testing
