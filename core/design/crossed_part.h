#pragma once

#include "lattice/vec.h"
#include "parts/catalogue.h"

namespace liftarm::design {

//! \brief How an axle, or a part on one, is to lie.
struct CrossedPlace {
  lattice::Vec3 centre;     //!< middle of its cross
  lattice::Vec3 direction;  //!< along the cross, unit
  lattice::Vec3 wing;       //!< where one wing goes, unit, across the direction
};

//! \brief The pose that brings an axle or an axle hole of a part there, with the direction `end` of
//! the part's own turned to `place.direction`. \pre `end` runs along the cross.
lattice::Pose crossedPose(const parts::Feature& cross,
                          lattice::Vec3 end,
                          const CrossedPlace& place);

}  // namespace liftarm::design
