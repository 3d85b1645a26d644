#pragma once

#include <string>
#include <vector>

#include "linkages/linkage_table.h"
#include "sketch/sketch.h"

namespace liftarm::linkages {

//! \brief A plane parallel to two axes, in which a path is drawn.
struct PathPlane {
  lattice::Axis normal = lattice::Axis::kY;
  double offset = 0.0;  //!< along the normal, modules

  //! The axes of u and v: the other two, in the order x, y, z, so that v is up where it can be.
  [[nodiscard]] lattice::Axis u() const;
  [[nodiscard]] lattice::Axis v() const;
  [[nodiscard]] lattice::Vec3 toSpace(Point p) const;
  [[nodiscard]] Point toPlane(lattice::Vec3 p) const;
};

//! \brief A linkage as a sketch: lines of frame, crank, rocker and coupler (one or two), in this
//! order, with a joint at each pin; the crank's must go all the way round.
//! \details Drawn at the angle of the crank at which fewest lines cross and nodes of different
//! links are farthest apart, since a drawing joins what meets.
sketch::Sketch sketchOf(const LinkageAnswer& answer, const PathPlane& plane);

//! \brief The pivots, crank pin first, of an answer where it is placed.
std::vector<Point> pivotsOf(const LinkageAnswer& answer);

//! \brief Crank's pin, rocker's pin and the drawing point at so many angles of the crank, placed.
std::vector<FourBarPose> posesOf(const LinkageAnswer& answer, int count);

}  // namespace liftarm::linkages
