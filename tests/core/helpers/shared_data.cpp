#include "core/helpers/shared_data.h"

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
