#pragma once

#include <string>
#include <string_view>

#include "base/status.h"

namespace liftarm::design {

//! \brief The symmetries that a sketch has but does not name yet (sketch/symmetry_finder.h), for a
//! person to confirm.
//! \return {"symmetries": [...], "notes": [...]}: reflections and translations as the sketch format
//! has them (DESIGN 3), so that they can be added as they are, and {"kind": "rotation", "axis",
//! "point", "order"} for information, which it has not; notes as in the report (notes_json.h); or
//! the one message that says what is wrong with the sketch.
base::Result<std::string> findSymmetriesJson(std::string_view sketchJson);

}  // namespace liftarm::design
