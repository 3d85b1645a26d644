#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/helpers/layouts.h"
#include "search/annealer.h"
#include "sketch/sketch_json.h"

namespace liftarm::search {
namespace {

std::vector<std::string> exampleFiles() {
  std::vector<std::string> files;
  const std::filesystem::path folder =
      std::filesystem::path(LIFTARM_SOURCE_DIR) / "public" / "examples";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.size() > 12 && name.substr(name.size() - 12) == ".sketch.json") {
      files.push_back(entry.path().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string nameOf(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = std::filesystem::path(info.param).filename().string();
  name.resize(name.size() - 12);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

struct Example : ::testing::TestWithParam<std::string> {};

TEST_P(Example, IsSearchedToTheEnd) {
  std::ifstream file(GetParam(), std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const base::Result<sketch::Sketch> sketch = sketch::readSketch(text);
  ASSERT_TRUE(sketch.ok()) << sketch.error().message;
  testing::LayoutBench bench(sketch.value());
  AnnealingOptions options;
  options.starts = 10;
  options.minIterations = 200;
  options.iterationsPerRun = 20;
  options.maxRounds = 1;
  Annealer annealer(bench.problem, bench.solver, options);
  // A round is what the options say; more than a hundred times that would be no end.
  const std::uint64_t limit = 100 * (200 + 20 * bench.problem.graph.runs.size());
  while (!annealer.advance(500)) {
    ASSERT_LT(annealer.iterations(), limit);
  }
  for (std::size_t r = 0; r < bench.problem.graph.runs.size(); ++r) {
    EXPECT_FALSE(annealer.best().covers[r].beams.empty()) << "run " << r;
  }
}

INSTANTIATE_TEST_SUITE_P(Public, Example, ::testing::ValuesIn(exampleFiles()), nameOf);

TEST(Examples, AreThere) {
  EXPECT_GE(exampleFiles().size(), 10U);
}

}  // namespace
}  // namespace liftarm::search
