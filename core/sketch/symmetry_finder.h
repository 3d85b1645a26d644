#pragma once

#include <vector>

#include "sketch/sketch.h"

namespace liftarm::sketch {

//! \brief A turn by 360 / order degrees about an axis that brings a sketch onto itself.
struct RotationSymmetry {
  lattice::Vec3 axis;   //!< unit length, its first component that is not zero positive
  lattice::Vec3 point;  //!< on the axis
  int order = 2;        //!< at least 2
};

//! \brief What findSymmetries offers.
struct FoundSymmetries {
  std::vector<Symmetry> symmetries;         //!< reflections, then translations
  std::vector<RotationSymmetry> rotations;  //!< for information: the sketch format has none
};

//! \brief Symmetries of a sketch as geometry: its set of unit edges, however they were drawn.
//!
//! \details An isometry that maps the nodes onto themselves keeps their mean, so it is given by the
//! images of two nodes; those are tried that have the same distance to the mean and as many edges.
//! What is found so is complete for the whole sketch and for each of its pieces: mirror planes and
//! axes of rotation. Beside them, mirror planes across principal and diagonal directions that at
//! least half of the lines share, and up to three independent shifts by which at least a quarter of
//! the lines fall on others, the shortest first.
//!
//! Exact lines, fixed hole axes and joints count: an image that differs in them is none. Nodes are
//! the same within kLengthTolerance, which snapping may leave. A mirror plane in which the whole
//! sketch lies is left out, and so is every symmetry that the sketch has already.
//!
//! \pre sketch was accepted by readSketch.
FoundSymmetries findSymmetries(const Sketch& sketch);

}  // namespace liftarm::sketch
