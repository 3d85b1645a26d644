#pragma once

#include <optional>
#include <string>
#include <vector>

namespace liftarm::testing {

//! \brief A file of the data beside the project (../shared), or nothing where it is missing.
std::optional<std::string> readSharedFile(const std::string& path);

//! \brief The names of the files of one of its folders that end so, without the ending, sorted;
//! none where it is missing.
std::vector<std::string> sharedFileNames(const std::string& folder, const std::string& ending);

//! \brief True where ../shared is there. False skips a test on a developer's machine; with CI=true
//! its absence is a failure, so that no test is lost in silence.
bool haveSharedData();

}  // namespace liftarm::testing

//! Begins a test that needs ../shared.
#define LIFTARM_NEED_SHARED_DATA()                        \
  do {                                                    \
    if (!::liftarm::testing::haveSharedData()) {          \
      GTEST_SKIP() << "../shared is not on this machine"; \
    }                                                     \
  } while (false)
