#pragma once

#include <string>

#include "model/model.h"

namespace liftarm::exporters {

//! \brief A model as an LDraw multi-part document (.mpd) with the building steps and subassemblies
//! of instructions/sequence.h.
//! \details Position p and rotation R (modules, Z up) become 20 M p and M R M^T with M: (x, y, z)
//! -> (x, -z, y), as in DESIGN 2. A subassembly is a submodel about its first part; a copy refers
//! to it, a mirrored or differently coloured one is a submodel of its own. Models of more than
//! analysis::kMaxPartsTakenApart parts are one step.
std::string writeLdraw(const model::Model& model, const parts::Catalogue& catalogue);

}  // namespace liftarm::exporters
