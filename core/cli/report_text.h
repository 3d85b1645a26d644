#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace liftarm::cli {

//! \brief A report (DESIGN 4) or the answer of a check for a person to read: a few lines of
//! numbers, the items of the check, and what is wrong where.
std::string reportText(const nlohmann::ordered_json& report);

//! \brief The answer of design::findSymmetriesJson for a person to read: one line for each, as it
//! can be copied into the sketch.
std::string symmetriesText(const nlohmann::ordered_json& found);

}  // namespace liftarm::cli
