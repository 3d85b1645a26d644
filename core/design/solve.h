#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "analysis/check.h"
#include "base/status.h"
#include "model/model.h"
#include "sketch/sketch.h"
#include "sketch/sketch_notes.h"

namespace liftarm::design {

//! \brief What a person may ask of a search; the rest is in `set`, as `liftarm solve --set`.
struct SolveOptions {
  std::uint64_t seed = 1;
  std::string preset = "balanced";
  std::string method = "default";
  std::map<std::string, std::string> set;  //!< keys of readSettings (settings.h)
};

//! \brief What a search found.
struct Design {
  model::Model model;               //!< placed parts, in modules
  analysis::CheckReport check;      //!< every check of the model, by code that knows no search
  std::vector<sketch::Note> notes;  //!< what reading moved, and what is most likely not meant
  bool buildable = false;           //!< every check holds and the search left nothing undone
  std::string report;               //!< the report of DESIGN 4 as JSON
};

//! \brief Builds a model of a sketch: what the command `solve` does, for programs.
//! \details Deterministic: the same sketch and options give the same model on every platform.
//! \param sketch Its lines need from and to alone; lengths are read off and snapped as in a file.
//! \return The best model found, which need not be buildable; kInvalidInput with one message that
//! names the place where sketch or options are at fault.
base::Result<Design> solve(const sketch::Sketch& sketch, const SolveOptions& options = {});

}  // namespace liftarm::design
