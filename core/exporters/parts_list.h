#pragma once

#include <string>
#include <vector>

#include "model/model.h"

namespace liftarm::exporters {

//! \brief So many of one part in one colour.
struct PartCount {
  std::string part;
  int color = 0;  //!< LDraw colour
  int count = 0;
};

//! \brief What a model is built from, most frequent first, then by number and colour.
std::vector<PartCount> countParts(const model::Model& model);

//! \brief The parts list that Rebrickable reads: `Part,Color,Quantity`. Its part numbers
//! are LDraw's for all parts of the catalogue; its colour numbers stand in wanted_list_colours.cpp.
std::string writePartsCsv(const model::Model& model);

}  // namespace liftarm::exporters
