#pragma once

#include <nlohmann/json.hpp>

#include "analysis/motion.h"

namespace liftarm::design {

//! \brief How a model stands and moves as {"freedoms", "groups", "motions", "joints", "balance",
//! "braces"} (design_session.h, analyseMotionJson).
nlohmann::ordered_json motionJson(const analysis::MotionReport& report);

}  // namespace liftarm::design
