#pragma once

#include <nlohmann/json.hpp>

#include "base/status.h"
#include "search/earlier_layout.h"

namespace liftarm::design {

//! \brief A layout that a later search may take over, as JSON: {"runs": [{"from", "to": [x,y,z],
//! "axis": 0 to 2, "beams": [[start, holes, layer, mate, form, tail]], "meets": [..]}]}, as in
//! search/earlier_layout.h.
nlohmann::json earlierJson(const search::EarlierLayout& earlier);

//! \return The layout, or that it is none. What is in it need not fit any sketch.
base::Result<search::EarlierLayout> readEarlier(const nlohmann::json& value);

}  // namespace liftarm::design
