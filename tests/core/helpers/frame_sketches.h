#pragma once

#include "core/helpers/sketches.h"

// Sketches that frames cover. Header only, for the same reason as sketches.h.

namespace liftarm::testing {

//! \brief A closed rectangle in the XY plane; 4 by 6 is what 64179 covers.
inline sketch::Sketch rectangleSketch(double x, double y) {
  return sketchFrom({{{0, 0, 0}, {x, 0, 0}},
                     {{x, 0, 0}, {x, y, 0}},
                     {{x, y, 0}, {0, y, 0}},
                     {{0, y, 0}, {0, 0, 0}}});
}

//! \brief Two bars of 2 edges joined by one of 4, as 14720.
inline sketch::Sketch smallHSketch() {
  return sketchFrom({{{0, -1, 0}, {0, 1, 0}}, {{4, -1, 0}, {4, 1, 0}}, {{0, 0, 0}, {4, 0, 0}}});
}

//! \brief Two rails of 10 edges with two rungs, as 64178; standing on the XY plane.
inline sketch::Sketch ladderSketch() {
  return sketchFrom({{{0, 0, 0}, {0, 0, 10}},
                     {{0, 4, 0}, {0, 4, 10}},
                     {{0, 0, 2}, {0, 4, 2}},
                     {{0, 0, 8}, {0, 4, 8}}});
}

//! \brief A rectangle of 4 by 6 with a leg at the middle of each long side, where 64179 has a hole
//! across.
inline sketch::Sketch benchSketch() {
  sketch::Sketch bench = rectangleSketch(4, 6);
  const sketch::Sketch legs = sketchFrom({{{0, 3, -6}, {0, 3, 0}}, {{4, 3, -6}, {4, 3, 0}}});
  bench.lines.insert(bench.lines.end(), legs.lines.begin(), legs.lines.end());
  return bench;
}

}  // namespace liftarm::testing
