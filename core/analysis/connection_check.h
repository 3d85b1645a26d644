#pragma once

#include "analysis/findings.h"
#include "analysis/scene.h"

namespace liftarm::analysis {

//! \brief Item 3 of DESIGN 5: every head in a hole fits and sits slot in slot, each hole slot holds
//! at most one head, and every part is held. \details A part is held by a pin in a pin hole or an
//! axle in an axle hole. An axle in a pin hole slides: a part that only such fits touch is loose.
ItemResult checkConnections(const Scene& scene);

}  // namespace liftarm::analysis
