#include "cli/best_of.h"

#include <fstream>

#include <gtest/gtest.h>

#include "cli/solve_seeds.h"
#include "core/helpers/sketches.h"
#include "sketch/sketch_json.h"

namespace liftarm::cli {
namespace {

using nlohmann::ordered_json;

TEST(BestOf, FollowsTheRuleThatThePageHasToo) {
  std::ifstream file(LIFTARM_SOURCE_DIR "/tests/contract/best-of.json");
  const ordered_json cases = ordered_json::parse(file, nullptr, false);
  ASSERT_TRUE(cases.is_array());
  ASSERT_FALSE(cases.empty());
  for (const ordered_json& one : cases) {
    Standing best = standingOf(one["reports"][0]);
    for (const ordered_json& report : one["reports"]) {
      const Standing standing = standingOf(report);
      best = isBetter(standing, best) ? standing : best;
    }
    EXPECT_EQ(best.seed, one["best"].get<std::uint64_t>()) << one["about"];
  }
}

TEST(BestOf, NeverPutsAResultBeforeItself) {
  const Standing standing{true, 0, 12, 30, 2.5, 4};
  EXPECT_FALSE(isBetter(standing, standing));
}

ordered_json quickSettings() {
  return {{"set", {{"effort", 0.1}}}};
}

TEST(SolveSeeds, GiveTheSameResultInAnyNumberOfThreads) {
  const std::string sketch = sketch::writeSketch(testing::cubeSketch(6));
  base::Result<Solution> one = solveSeeds(sketch, quickSettings(), 3, 4, 1);
  base::Result<Solution> three = solveSeeds(sketch, quickSettings(), 3, 4, 3);
  ASSERT_TRUE(one.ok() && three.ok());
  EXPECT_EQ(one.value().modelJson, three.value().modelJson);
  Solution a = std::move(one).value();
  Solution b = std::move(three).value();
  a.report.erase("seconds");
  b.report.erase("seconds");
  EXPECT_EQ(a.report.dump(), b.report.dump());
}

TEST(SolveSeeds, KeepTheModelOfTheBestSeed) {
  const std::string sketch = sketch::writeSketch(testing::cubeSketch(6));
  const base::Result<Solution> best = solveSeeds(sketch, quickSettings(), 1, 3, 2);
  ASSERT_TRUE(best.ok());
  EXPECT_EQ(best.value().report["seeds"].size(), 3U);
  ordered_json settings = quickSettings();
  settings["seed"] = best.value().report["seed"];
  const base::Result<Solution> alone = solveOnce(sketch, settings);
  ASSERT_TRUE(alone.ok());
  EXPECT_EQ(alone.value().modelJson, best.value().modelJson);
}

TEST(SolveSeeds, RefuseWhatOneSeedRefuses) {
  const base::Result<Solution> refused = solveSeeds("{}", quickSettings(), 1, 3, 2);
  EXPECT_FALSE(refused.ok());
}

}  // namespace
}  // namespace liftarm::cli
