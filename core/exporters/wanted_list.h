#pragma once

#include <string>
#include <string_view>

#include "base/status.h"
#include "model/model.h"

namespace liftarm::exporters {

//! \brief A colour's numbers in the three catalogues that people buy and count parts with.
struct ColourIds {
  int ldraw = 0;
  int brickLink = 0;
  int rebrickable = 0;
  std::string_view name;  //!< BrickLink's English name
};

//! \brief The numbers of an LDraw colour, or nullptr for one that our table does not hold.
//! \details Sources: LDraw's LDConfig.ldr (codes), BrickLink's colour guide and Rebrickable's
//! colour table (their own numbers and names).
const ColourIds* findColourIds(int ldrawColour);

//! \brief A BrickLink wanted list: one `ITEM` for each part in each colour, in the order of the
//! parts list. \return The XML text, or the message that names the colour that BrickLink's numbers
//! are not known for.
base::Result<std::string> writeWantedList(const model::Model& model);

}  // namespace liftarm::exporters
