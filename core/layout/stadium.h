#pragma once

#include "lattice/vec.h"

namespace liftarm::layout {

inline constexpr double kBeamRadius = 0.45;
inline constexpr double kFrameRadius = 0.5;  // bars of frames are as wide as they are thick

//! \brief The solid of a straight beam: all points within its radius of a segment, measured across
//! the hole axis, and within half a module along it. Exact for real beams, on and off the lattice.
struct Stadium {
  lattice::Vec3 from;  //!< first hole
  lattice::Vec3 to;    //!< last hole
  lattice::Axis axis;  //!< of the holes; from and to agree along it
  double radius = kBeamRadius;
};

inline constexpr double kBeamHalfThickness = 0.5;

//! Solids that touch, or enter each other by less than this, do not collide.
inline constexpr double kContactTolerance = 0.02;

//! \brief Whether two beams interpenetrate.
//! \details Same hole axis: layers overlap and the segments come closer than two radii. Different
//! hole axes: along the third axis both solids, each cut to the other's thickness, must overlap;
//! the cut stadium's extent is closed-form, so the test is exact.
bool overlap(const Stadium& a, const Stadium& b);

//! \brief Distance of a point from a beam's middle line across its hole axis, if the point's unit
//! cell overlaps the beam's thickness; else a large number.
double crossDistance(const Stadium& beam, lattice::Vec3 point);

}  // namespace liftarm::layout
