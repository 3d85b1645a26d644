#pragma once

#include <vector>

#include "sketch/arrangement.h"
#include "sketch/sketch.h"

namespace liftarm::sketch {

//! \brief An isometry that keeps one point: p -> linear * (p - centre) + centre.
struct PointIsometry {
  lattice::Mat3 linear;
  lattice::Vec3 centre;

  [[nodiscard]] lattice::Vec3 apply(lattice::Vec3 p) const {
    return linear * (p - centre) + centre;
  }
};

//! \brief What a reflection or a rotation does to points. \pre symmetry is no translation.
PointIsometry isometryOf(const Symmetry& symmetry);

//! \brief All isometries but the identity, and but mirrors that move no node, that bring the unit
//! edges of an arrangement onto themselves with their rules and joints. Each once by its effect on
//! the nodes, except that a flat sketch has rotations beside equal mirrors.
//! \param piece A connected part, or -1 for all.
std::vector<PointIsometry> pointSymmetries(const Arrangement& arrangement, int piece);

//! \brief Whether a run crosses its own image, both going on beyond: then no two beams can lie as
//! the map has them, since one must pass the other on another layer.
bool crossesItself(const Arrangement& arrangement, const PointIsometry& map);

}  // namespace liftarm::sketch
