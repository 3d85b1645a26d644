#pragma once

#include <vector>

#include "analysis/scene.h"

namespace liftarm::analysis {

//! \brief A point of a part that touches the ground.
struct Foot {
  int part = -1;
  lattice::Vec3 at;  //!< world, modules
};

//! \brief How a model comes to rest on a table.
struct Rest {
  lattice::Vec3 up{0, 0, 1};  //!< away from the table, in the model's own axes
  double tilt = 0.0;          //!< degrees between that and the drawing's z
  std::vector<Foot> feet;
};

//! Points this little above the table rest on it too, modules: beams laid flat reach 0.5 below
//! their holes, beams on edge 0.45.
inline constexpr double kRestTolerance = 0.06;

//! \brief Rolls a rigid model over its feet until its centre of mass is above them.
//! \details Feet are low points of bodies and of heads that are in no hole. A model that stands as
//! drawn is not turned. \param centre Of mass, or of all that presses down; world, modules.
Rest findRest(const Scene& scene, lattice::Vec3 centre);

}  // namespace liftarm::analysis
