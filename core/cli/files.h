#pragma once

#include <cstddef>
#include <string>

#include "base/status.h"

namespace liftarm::cli {

//! \brief The whole content of a file, or one message that says why it cannot be read.
//! \param maxBytes A larger file is refused before it is read.
base::Result<std::string> readFile(const std::string& path, std::size_t maxBytes);

//! \brief Writes a file, replacing what was there. \return The path, or why it cannot be written.
base::Result<std::string> writeFile(const std::string& path, const std::string& content);

//! \brief Creates a folder with all folders above it, unless it is there.
base::Result<std::string> makeFolder(const std::string& path);

//! \brief `a/b/Seesaw.sketch.json` -> `Seesaw`.
std::string baseName(const std::string& path);

}  // namespace liftarm::cli
