#include "analysis/loads.h"

#include <cstddef>
#include <string>

#include "model/number_text.h"

namespace liftarm::analysis {

namespace {

PlacedLoad nearest(const Scene& scene,
                   const std::vector<Skeleton>& skeletons,
                   const PointLoad& load) {
  PlacedLoad placed;
  placed.at = load.at;
  placed.force = load.force;
  double least = kLoadReach;
  for (std::size_t part = 0; part < skeletons.size(); ++part) {
    const lattice::Pose& pose = scene.model->parts[part].pose;
    for (std::size_t p = 0; p < skeletons[part].points.size(); ++p) {
      const double distance = lattice::length(pose.apply(skeletons[part].points[p]) - load.at);
      if (distance < least) {
        least = distance;
        placed.part = static_cast<int>(part);
        placed.point = static_cast<int>(p);
      }
    }
  }
  return placed;
}

}  // namespace

base::Result<std::vector<PlacedLoad>> placeLoads(const Scene& scene,
                                                 const std::vector<Skeleton>& skeletons,
                                                 const std::vector<PointLoad>& loads) {
  std::vector<PlacedLoad> result;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    result.push_back(nearest(scene, skeletons, loads[i]));
    if (result.back().part < 0) {
      return base::Error{base::Status::kInvalidInput,
                         "loads[" + std::to_string(i) + "].at: no part within " +
                             model::numberText(kLoadReach) + " modules of " +
                             pointText(loads[i].at)};
    }
  }
  return result;
}

}  // namespace liftarm::analysis
