#include "core/helpers/shared_data.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

#include <gtest/gtest.h>

namespace liftarm::testing {

namespace {

std::filesystem::path sharedFolder() {
  return std::filesystem::path(LIFTARM_SOURCE_DIR) / ".." / "shared";
}

}  // namespace

std::optional<std::string> readSharedFile(const std::string& path) {
  std::ifstream file(sharedFolder() / path, std::ios::binary);
  if (!file) {
    return std::nullopt;
  }
  return std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
}

std::vector<std::string> sharedFileNames(const std::string& folder, const std::string& ending) {
  std::vector<std::string> names;
  if (std::filesystem::exists(sharedFolder() / folder)) {
    for (const auto& entry : std::filesystem::directory_iterator(sharedFolder() / folder)) {
      const std::string name = entry.path().filename().string();
      if (name.size() > ending.size() &&
          name.compare(name.size() - ending.size(), ending.size(), ending) == 0) {
        names.push_back(name.substr(0, name.size() - ending.size()));
      }
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

bool haveSharedData() {
  if (std::filesystem::exists(sharedFolder() / "parts")) {
    return true;
  }
  const char* ci = std::getenv("CI");
  if (ci != nullptr && std::string_view(ci) == "true") {
    ADD_FAILURE() << "CI=true, but ../shared is missing";
  }
  return false;
}

}  // namespace liftarm::testing
