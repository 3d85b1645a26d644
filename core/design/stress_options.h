#pragma once

#include <string_view>

#include "analysis/frame_model.h"
#include "base/status.h"

namespace liftarm::design {

//! \brief Reads {"friction": "held" | "free" | "locked", "heldStiffness": N mm / rad, "loads":
//! [{"at": [x, y, z] in modules, "force": [x, y, z] in N}]}; everything optional, empty text is {}.
//! \return kInvalidInput with one message that names the place.
base::Result<analysis::StressOptions> readStressOptions(std::string_view json);

}  // namespace liftarm::design
