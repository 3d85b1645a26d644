#pragma once

#include <vector>

#include "analysis/frame_skeleton.h"
#include "analysis/scene.h"
#include "base/status.h"

namespace liftarm::analysis {

//! \brief A force in one point of the model.
struct PointLoad {
  lattice::Vec3 at;     //!< world, modules; on or near a part
  lattice::Vec3 force;  //!< N
};

//! \brief A force on the point of a part's skeleton that carries it as if by a rigid arm.
struct PlacedLoad {
  int part = -1;
  int point = -1;       //!< of the part's skeleton
  lattice::Vec3 at;     //!< world, modules
  lattice::Vec3 force;  //!< N
};

//! A load further than this from every part is refused, modules.
inline constexpr double kLoadReach = 2.0;

//! \brief Finds what carries each load: the nearest point of any part's skeleton.
//! \param skeletons One per part of the scene. \return kInvalidInput for a load that is near no
//! part.
base::Result<std::vector<PlacedLoad>> placeLoads(const Scene& scene,
                                                 const std::vector<Skeleton>& skeletons,
                                                 const std::vector<PointLoad>& loads);

}  // namespace liftarm::analysis
