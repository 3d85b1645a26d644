#pragma once

#include <string>

#include "model/model.h"

namespace liftarm::exporters {

//! \brief A model as an LDraw multi-part document (.mpd) with one part a line and building steps
//! from the ground up. \details Position p and rotation R (modules, Z up) become 20 M p and M R M^T
//! with M: (x, y, z) -> (x, -z, y), as in DESIGN 2. Parts on one height make one step.
std::string writeLdraw(const model::Model& model, const parts::Catalogue& catalogue);

}  // namespace liftarm::exporters
