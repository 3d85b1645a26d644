#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/well_built.h"

namespace liftarm::design {

//! \brief How well a model is built as {"passed", "of", "items"}; each item is {"id", "title",
//! "ok", "applies", "detail", "figures": {name: number}, "places": [problem]}.
nlohmann::ordered_json wellBuiltJson(const std::vector<analysis::WellBuiltItem>& items);

}  // namespace liftarm::design
