#pragma once

#include <vector>

#include "analysis/scene.h"

namespace liftarm::analysis {

//! \brief Fits that keep a pin or axle from spinning on the spot.
//! \details A pin between two round holes spins freely and an axle slides, which moves nothing
//! else. Each such group (pins, axles, bushes and gears joined rigidly, with all other fits on one
//! axis) is held in its first fit: that takes the idle motion out and restrains no other part.
//! \return One per connection of the scene: whether it holds turning and sliding for that reason.
std::vector<bool> idleHolds(const Scene& scene);

}  // namespace liftarm::analysis
