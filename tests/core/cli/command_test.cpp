#include "core/cli/command.h"

#include <string>

#include <nlohmann/json.hpp>

#include "core/helpers/models.h"
#include "model/model_json.h"

namespace liftarm::cli {
namespace {

using testing::Command;
using testing::Outcome;

TEST_F(Command, SolvesASquareAndItsFilesPassTheCheck) {
  const std::string sketch = write("Square.sketch.json",
                                   testing::sketchOf({{{0, 0, 0}, {8, 0, 0}},
                                                      {{8, 0, 0}, {8, 8, 0}},
                                                      {{8, 8, 0}, {0, 8, 0}},
                                                      {{0, 8, 0}, {0, 0, 0}}}));
  const Outcome solved =
      run("solve '" + sketch + "' -o '" + folder_.string() + "' --seed 3 --json");
  ASSERT_EQ(solved.exitCode, 0) << solved.err << solved.out;
  const auto report = nlohmann::json::parse(solved.out);
  EXPECT_EQ(report.at("seed"), 3);
  EXPECT_TRUE(report.at("buildable").get<bool>());
  EXPECT_TRUE(report.at("seconds").contains("stageTwo"));
  EXPECT_EQ(read("Square.mpd").find("0 FILE "), 0U);
  EXPECT_EQ(read("Square.parts.csv").find("Part,Color,Quantity\n"), 0U);
  EXPECT_EQ(run("check '" + (folder_ / "Square.model.json").string() + "'").exitCode, 0);
}

TEST_F(Command, TheSameSeedWritesTheSameBytes) {
  const std::string sketch =
      write("a.json", testing::sketchOf({{{0, 0, 0}, {8, 0, 0}}, {{4, 0, 0}, {4, 0, 6}}}));
  run("solve '" + sketch + "' -o '" + folder_.string() + "' --seed 5");
  const std::string first = read("a.model.json");
  ASSERT_FALSE(first.empty());
  run("solve '" + sketch + "' -o '" + folder_.string() + "' --seed 5");
  EXPECT_EQ(read("a.model.json"), first);
}

// 12-12-17 is 0.03 modules off closing: within the play of the pins, and no beam is the worse for
// it.
TEST_F(Command, LengthsThatDoNotQuiteCloseAreBuiltAndSaid) {
  const std::string sketch =
      write("Slope.json",
            testing::sketchOf(
                {{{0, 0, 0}, {12, 0, 0}}, {{12, 0, 0}, {12, 0, 12}}, {{0, 0, 0}, {12, 0, 12}}}));
  const Outcome solved = run("solve '" + sketch + "' -o '" + folder_.string() + "'");
  EXPECT_EQ(solved.exitCode, 0) << solved.out;
  EXPECT_NE(solved.out.find("its length of 17 does not close"), std::string::npos) << solved.out;
  EXPECT_EQ(run("check '" + (folder_ / "Slope.model.json").string() + "'").exitCode, 0);
}

// 8-9-12 and 13-1-13 are 0.04 modules off: both ends of every line share what is left.
TEST_F(Command, LengthsThatCloseWithinThePlayAtBothEndsOfALineAreBuilt) {
  for (const auto& [width, height] : {std::pair(8, 9), std::pair(13, 1)}) {
    const lattice::Vec3 corner{1.0 * width, 0, 0};
    const lattice::Vec3 top{1.0 * width, 1.0 * height, 0};
    const std::string sketch =
        write("Slope.json", testing::sketchOf({{{}, corner}, {corner, top}, {{}, top}}));
    const Outcome solved = run("solve '" + sketch + "' -o '" + folder_.string() + "'");
    EXPECT_EQ(solved.exitCode, 0) << solved.out;
    EXPECT_EQ(run("check '" + (folder_ / "Slope.model.json").string() + "'").exitCode, 0);
  }
}

TEST_F(Command, CheckOfABadModelExitsWithTwo) {
  model::Model model = testing::squareFrame();
  model.parts.pop_back();
  model.parts.erase(model.parts.begin() + 4);
  const std::string path = write("bad.model.json", model::writeModel(model));
  const Outcome outcome = run("check '" + path + "'");
  EXPECT_EQ(outcome.exitCode, 2);
  EXPECT_NE(outcome.out.find("NOT buildable"), std::string::npos);
  EXPECT_NE(outcome.out.find("separate"), std::string::npos);
}

TEST_F(Command, ListsPlacementsOfThePartsInUse) {
  const std::string sketch = write("line.json", testing::sketchOf({{{0, 0, 0}, {8, 0, 0}}}));
  const Outcome outcome = run("placements '" + sketch + "' --set lengths=2,5 --set owned.32316=1");
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  const auto listed = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(listed.at("format"), "liftarm-placements");
  EXPECT_EQ(listed.at("edges").size(), 8U);
  EXPECT_EQ(listed.at("quickBound"), 2);
  EXPECT_EQ(listed.at("limits").at(0).at("owned"), 1);
  for (const auto& cover : listed.at("covers")) {
    EXPECT_EQ(cover.at("kind"), "straight");
    EXPECT_LE(cover.at("edges").size(), 4U);
  }
}

TEST_F(Command, ListsEdgesThatBeamsMustCoverAsThePresetBridges) {
  const std::string sketch = write("square.json",
                                   testing::sketchOf({{{0, 0, 0}, {4, 0, 0}},
                                                      {{4, 0, 0}, {4, 4, 0}},
                                                      {{4, 4, 0}, {0, 4, 0}},
                                                      {{0, 4, 0}, {0, 0, 0}}}));
  for (const auto& [preset, edges] : {std::pair("simple", 16U), std::pair("balanced", 8U)}) {
    const Outcome outcome = run("placements '" + sketch + "' --preset " + preset);
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(nlohmann::json::parse(outcome.out).at("edges").size(), edges) << preset;
  }
}

TEST_F(Command, TellsThatStageOneLeavesFewerDifferencesThanChance) {
  const std::string sketch = write("table.json",
                                   testing::sketchOf({{{0, 0, 0}, {0, 0, 5}},
                                                      {{8, 0, 0}, {8, 0, 5}},
                                                      {{0, 0, 5}, {8, 0, 5}},
                                                      {{0, 0, 5}, {0, 6, 5}}}));
  const Outcome outcome = run("stage-one '" + sketch + "'");
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  const auto told = nlohmann::json::parse(outcome.out);
  const double random = told.at("random").at("differences");
  EXPECT_LE(told.at("paper").at("differences"), random);
  EXPECT_LE(told.at("default").at("differences"), random);
  EXPECT_GE(told.at("random").at("most"), told.at("random").at("least"));
}

TEST_F(Command, PrintsTheFactsAboutParts) {
  const Outcome outcome = run("parts");
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_GT(nlohmann::json::parse(outcome.out).at("parts").size(), 50U);
}

TEST_F(Command, PrintsTheStressOfAModelUnderALoad) {
  const std::string path = write("frame.model.json", model::writeModel(testing::squareFrame()));
  const Outcome outcome = run("stress '" + path + "' --options '{\"friction\": \"locked\"}'");
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_TRUE(nlohmann::json::parse(outcome.out).at("ok"));
  expectRefused("stress '" + path + "' --options '{\"friction\": \"glue\"}'", "friction");
}

TEST_F(Command, SolvesByARival) {
  const std::string sketch = write("line.json", testing::sketchOf({{{0, 0, 0}, {8, 0, 0}}}));
  const Outcome outcome = run("solve '" + sketch + "' --no-files --json --method greedy");
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_EQ(nlohmann::json::parse(outcome.out).at("method"), "greedy");
}

TEST_F(Command, RefusesBadInputWithOneLine) {
  const std::string good = write("good.json", testing::sketchOf({{{0, 0, 0}, {8, 0, 0}}}));
  expectRefused("solve '" + (folder_ / "none.json").string() + "'", "cannot be opened");
  expectRefused("solve '" + folder_.string() + "'", "is a folder");
  expectRefused("solve '" + write("broken.json", "{\"format\":") + "'", "not valid JSON");
  expectRefused("solve '" + write("empty.json", "") + "'", "empty.json: ");
  expectRefused("solve '" + write("half.json", testing::sketchOf({{{0, 0, 0}, {4.5, 0, 0}}})) + "'",
                "4.5 is not a whole number");
  expectRefused("solve '" + good + "' --seed x", "seed");
  expectRefused("solve '" + good + "' --set nonsense", "expected key=value");
  expectRefused("solve '" + good + "' --set nosuchkey=1", "nosuchkey");
  expectRefused("check '" + good + "'", "liftarm-model");
  expectRefused("placements '" + good + "' --set nosuchkey=1", "nosuchkey");
  expectRefused("stage-one '" + good + "' --method magic", "ant-colony");
  expectRefused("solve", "SKETCH");
}

TEST_F(Command, HelpTellsAllOptions) {
  const Outcome outcome = run("--help");
  EXPECT_EQ(outcome.exitCode, 0);
  for (const char* word : {"solve",
                           "check",
                           "placements",
                           "stage-one",
                           "parts",
                           "stress",
                           "--seed",
                           "--preset",
                           "--method",
                           "--set",
                           "--json",
                           "-o"}) {
    EXPECT_NE(outcome.out.find(word), std::string::npos) << word;
  }
}

}  // namespace
}  // namespace liftarm::cli
