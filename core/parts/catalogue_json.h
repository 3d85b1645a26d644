#pragma once

#include <string_view>
#include <vector>

#include "base/status.h"
#include "parts/catalogue.h"

namespace liftarm::parts {

//! \brief Reads the parts of a catalogue as scripts/make-catalogue.mjs writes it.
//! \param json The whole text. Positions and lengths in modules, masses in grams.
//! \return The parts in the order of the text, or kInvalidInput with the part at fault.
base::Result<std::vector<Part>> readCatalogue(std::string_view json);

}  // namespace liftarm::parts
