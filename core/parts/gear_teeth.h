#pragma once

#include "parts/catalogue.h"

namespace liftarm::parts {

//! \brief How many teeth a gear has: its LDraw title counts them ("Technic Gear 24 Tooth ...").
//! \return 0 for every other part.
int teethOf(const Part& part);

}  // namespace liftarm::parts
