#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/status.h"

namespace liftarm::cli {

//! \brief The whole content of a file, or one message that says why it cannot be read.
//! \param maxBytes A larger file is refused before it is read.
base::Result<std::string> readFile(const std::string& path, std::size_t maxBytes);

//! \brief A file to be written.
struct FileText {
  std::string path;
  std::string content;
};

//! \brief Writes files, all of them or none, replacing what was there.
//! \details Each is written whole under another name beside its place, and takes its place when all
//! of them are on the disk; what goes wrong until then leaves what was there. A device or a pipe is
//! written to as it is. \return How many, or why they cannot be written.
base::Result<std::size_t> writeFiles(const std::vector<FileText>& files);

//! \brief Whether two paths lead to the same file; false where one of them is not there.
bool isSameFile(const std::string& a, const std::string& b);

//! \brief Creates a folder with all folders above it, unless it is there.
base::Result<std::string> makeFolder(const std::string& path);

//! \brief `a/b/Seesaw.sketch.json` -> `Seesaw`.
std::string baseName(const std::string& path);

}  // namespace liftarm::cli
