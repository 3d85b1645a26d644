#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "sketch/sketch_notes.h"

namespace liftarm::design {

//! \brief Notes on a sketch as [{"kind", "message", "at", "lines", "mend"}]. `mend` is what would
//! put it right: lines with their new ends, [{"line", "from", "to"}], of which those without a
//! number are new.
nlohmann::json notesJson(const std::vector<sketch::Note>& notes);

}  // namespace liftarm::design
