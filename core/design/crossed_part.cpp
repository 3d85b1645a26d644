#include "design/crossed_part.h"

namespace liftarm::design {

lattice::Pose crossedPose(const parts::Feature& cross,
                          lattice::Vec3 end,
                          const CrossedPlace& place) {
  const lattice::Vec3 own = *cross.wing;
  const lattice::Mat3 turned =
      lattice::fromColumns(
          place.direction, place.wing, lattice::cross(place.direction, place.wing)) *
      lattice::transposed(lattice::fromColumns(end, own, lattice::cross(end, own)));
  return {place.centre - turned * cross.center, turned};
}

}  // namespace liftarm::design
