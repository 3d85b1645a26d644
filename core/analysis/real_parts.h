#pragma once

#include "analysis/findings.h"
#include "analysis/scene.h"

namespace liftarm::analysis {

//! \brief Item 1 of DESIGN 5: every part is in the catalogue (whose geometry is LDraw's, as its
//! tests hold), and is turned by a proper rotation: neither mirrored nor scaled.
ItemResult checkRealParts(const Scene& scene);

}  // namespace liftarm::analysis
