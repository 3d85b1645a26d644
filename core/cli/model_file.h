#pragma once

#include <string>
#include <vector>

#include "base/status.h"

namespace liftarm::cli {

//! \brief A model file, or what was made of another program's.
struct ModelText {
  std::string json;
  std::vector<std::string> notes;  //!< what of it was left out or taken otherwise
};

//! \brief Reads a model: a model file as it is, an LDraw document (.ldr, .mpd) by
//! importers/ldraw.h. What a file is, its first rows say.
base::Result<ModelText> readModelFile(const std::string& path);

}  // namespace liftarm::cli
