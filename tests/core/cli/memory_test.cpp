// The largest inputs that are legal, and those beyond, under a limit that the system sets.
#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/cli/command.h"
#include "model/model_json.h"
#include "sketch/sketch_json.h"

namespace liftarm {
namespace {

using nlohmann::json;

constexpr int kHalfGigabyte = 512 * 1024;  // in the kilobytes of `ulimit -v`

class Memory : public testing::Command {
 protected:
  void SetUp() override {
    Command::SetUp();
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the sanitizer reserves more addresses than there is memory";
#endif
  }

  //! The exit code of the command, which has half a gigabyte.
  static int runIn(const std::string& what, const std::string& file) {
    const std::string line = "ulimit -v " + std::to_string(kHalfGigabyte) + "; exec '" +
                             LIFTARM_COMMAND + "' " + what + " '" + file + "' >/dev/null 2>&1";
    return WEXITSTATUS(std::system(("sh -c \"" + line + "\"").c_str()));
  }
};

//! As many lines as are read, in a lattice: each next to six others.
json largestSketch() {
  constexpr int kSide = 19;
  constexpr int kStep = 5;
  json lines = json::array();
  const auto put = [&](int x, int y, int z, int toX, int toY, int toZ) {
    if (toX < kSide && toY < kSide && toZ < kSide && lines.size() < sketch::kMaxLines) {
      lines.push_back({{"from", {kStep * x, kStep * y, kStep * z}},
                       {"to", {kStep * toX, kStep * toY, kStep * toZ}}});
    }
  };
  for (int x = 0; x < kSide; ++x) {
    for (int y = 0; y < kSide; ++y) {
      for (int z = 0; z < kSide; ++z) {
        put(x, y, z, x + 1, y, z);
        put(x, y, z, x, y + 1, z);
        put(x, y, z, x, y, z + 1);
      }
    }
  }
  return {{"format", "technic-sketch"}, {"version", 1}, {"lines", lines}};
}

TEST_F(Memory, TheLargestSketchIsReadInHalfAGigabyte) {
  EXPECT_EQ(runIn("symmetries", write("large.sketch.json", largestSketch().dump())), 0);
}

TEST_F(Memory, PlacementsOfTheLargestSketchAreRefused) {
  EXPECT_EQ(runIn("placements", write("large.sketch.json", largestSketch().dump())), 1);
}

TEST_F(Memory, AModelOfMorePartsThanAreReadIsRefused) {
  const json part = {{"part", "32525"},
                     {"color", 71},
                     {"position", {0, 0, 0}},
                     {"rotation", {1, 0, 0, 0, 1, 0, 0, 0, 1}}};
  const json model = {{"format", "liftarm-model"},
                      {"version", 1},
                      {"name", ""},
                      {"parts", json(model::kMaxParts + 1, part)}};
  EXPECT_EQ(runIn("check", write("large.model.json", model.dump())), 1);
}

TEST_F(Memory, AFileTooLargeIsRefusedBeforeItIsRead) {
  const std::string file = write("large.model.json", "{}");
  std::filesystem::resize_file(file, std::uintmax_t{8} << 30U);
  EXPECT_EQ(runIn("check", file), 1);
  EXPECT_EQ(runIn("symmetries", file), 1);
}

}  // namespace
}  // namespace liftarm
