#include "cli/files.h"

#include <filesystem>
#include <fstream>
#include <system_error>

namespace liftarm::cli {

namespace {

namespace fs = std::filesystem;

base::Error failed(const std::string& message) {
  return {base::Status::kInvalidInput, message};
}

}  // namespace

base::Result<std::string> readFile(const std::string& path, std::size_t maxBytes) {
  std::error_code error;
  if (fs::is_directory(path, error)) {
    return failed(path + ": is a folder, not a file");
  }
  const bool plain = fs::is_regular_file(path, error);
  if (plain && fs::file_size(path, error) > maxBytes) {
    return failed(path + ": larger than the limit of " + std::to_string(maxBytes) + " bytes");
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    return failed(path + ": cannot be opened");
  }
  // Pipes have no size: stop after the limit, so that an endless one ends too.
  std::string text;
  std::string block(1U << 16U, '\0');
  while (file && text.size() <= maxBytes) {
    file.read(block.data(), static_cast<std::streamsize>(block.size()));
    text.append(block, 0, static_cast<std::size_t>(file.gcount()));
  }
  if (text.size() > maxBytes) {
    return failed(path + ": larger than the limit of " + std::to_string(maxBytes) + " bytes");
  }
  return text;
}

base::Result<std::string> makeFolder(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (!fs::is_directory(path)) {
    return failed(path + ": cannot be made a folder");
  }
  return path;
}

std::string baseName(const std::string& path) {
  std::string name = fs::path(path).filename().string();
  for (const std::string ending : {".json", ".sketch", ".model"}) {
    if (name.size() > ending.size() &&
        name.compare(name.size() - ending.size(), ending.size(), ending) == 0) {
      name.resize(name.size() - ending.size());
    }
  }
  return name;
}

}  // namespace liftarm::cli
