#pragma once

#include <vector>

#include "gears/shaft_plan.h"
#include "model/model.h"

namespace liftarm::design {

//! \brief The axles, gears and bushes of a plan in their places.
std::vector<model::PlacedPart> shaftParts(const gears::ShaftPlan& plan);

}  // namespace liftarm::design
