#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace liftarm::cli {

//! \brief The stress analysis of a model under its own weight, without its numbers part by part.
//! \return {"ok", "message", "friction", ...} as design::analyseStressJson; `friction` is what was
//! taken: "held", or "locked" where the model folds with that. {"ok": false, "message"} where it
//! cannot be analysed.
nlohmann::ordered_json stressSummary(const std::string& modelJson);

//! \brief One line on it for a person to read.
std::string stressText(const nlohmann::ordered_json& summary);

}  // namespace liftarm::cli
