#pragma once

#include <string>

#include "model/model.h"

namespace liftarm::exporters {

//! \brief The parts as a table for spreadsheet programs (RFC 4180, UTF-8, comma, decimal point):
//! `Name,Number,Colour,Count,Mass each (g),Mass (g),Mass is an estimate`, and a last row with sums.
//! \details A text that a spreadsheet would take for a formula is made harmless.
std::string writeSpreadsheet(const model::Model& model, const parts::Catalogue& catalogue);

}  // namespace liftarm::exporters
