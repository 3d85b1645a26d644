#include "design/owned_parts.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/helpers/sketches.h"
#include "core/helpers/solved.h"
#include "design/design_session.h"
#include "layout/bent_beam.h"
#include "model/model_json.h"
#include "sketch/sketch_json.h"

namespace liftarm::design {
namespace {

using nlohmann::json;
using testing::solve;
using testing::Solved;

TEST(OwnedParts, OfWhichThereAreNoneAreNotUsed) {
  // A square of nine nodes a side takes four beams of nine, 40490.
  const Solved solved = solve(testing::squareSketch(8), {{"owned.40490", 0}});
  EXPECT_EQ(solved.count("40490"), 0);
  EXPECT_TRUE(solved.report["buildable"].get<bool>()) << solved.report["problems"];
}

TEST(OwnedParts, AreNotExceededWhereOthersServe) {
  const Solved solved = solve(testing::squareSketch(8), {{"owned.40490", 2}});
  EXPECT_LE(solved.count("40490"), 2);
  EXPECT_TRUE(solved.report["buildable"].get<bool>()) << solved.report["problems"];
  EXPECT_TRUE(solved.report["missing"].empty());
}

TEST(OwnedParts, SpacersAreNotExceeded) {
  const sketch::Sketch grid = testing::gridSketch(4);
  const Solved usual = solve(grid, json::object());
  const int spacers = usual.count("18654");
  EXPECT_EQ(usual.report["filledGaps"], spacers);
  ASSERT_GT(spacers, 0);
  const Solved none = solve(grid, {{"owned.18654", 0}});
  EXPECT_EQ(none.count("18654"), 0);
  EXPECT_TRUE(none.report["buildable"].get<bool>()) << none.report["problems"];
  const Solved few = solve(grid, {{"owned.18654", 1}});
  EXPECT_LE(few.count("18654"), 1);
  EXPECT_TRUE(few.report["buildable"].get<bool>()) << few.report["problems"];
}

TEST(OwnedParts, OfBentBeamsAreNotExceeded) {
  // Two L beams make this rectangle, straight ones would be four.
  const sketch::Sketch rectangle = testing::sketchFrom({{{0, 0, 0}, {4, 0, 0}},
                                                        {{4, 0, 0}, {4, 2, 0}},
                                                        {{4, 2, 0}, {0, 2, 0}},
                                                        {{0, 2, 0}, {0, 0, 0}}});
  const Solved whole = solve(rectangle, json::object());
  const auto bentIn = [](const Solved& solved) {
    int count = 0;
    for (const layout::BentBeam& bent : layout::bentBeams()) {
      count += solved.count(bent.part);
    }
    return count;
  };
  ASSERT_GT(bentIn(whole), 1);
  json owned = json::object();
  for (const layout::BentBeam& bent : layout::bentBeams()) {
    owned["owned." + bent.part] = bent.part == "32526" ? 1 : 0;
  }
  const Solved solved = solve(rectangle, owned);
  EXPECT_EQ(bentIn(solved), solved.count("32526"));
  EXPECT_LE(solved.count("32526"), 1);
  EXPECT_TRUE(solved.report["buildable"].get<bool>()) << solved.report["problems"];
}

TEST(OwnedParts, OfConnectorsAreNotExceededWhereOthersServe) {
  const Solved whole = solve(testing::cubeSketch(8), json::object());
  ASSERT_GT(whole.count("55615"), 0);
  const Solved solved = solve(testing::cubeSketch(8), {{"owned.55615", 1}});
  EXPECT_LE(solved.count("55615"), 1);
  EXPECT_TRUE(solved.report["buildable"].get<bool>()) << solved.report["problems"];
}

TEST(OwnedParts, ThatDoNotSufficeAreNamedWithTheirNumber) {
  // One pin for four corners, and nothing else that could join them.
  const Solved solved = solve(testing::squareSketch(8),
                              {{"owned.2780", 1},
                               {"owned.6558", 0},
                               {"owned.87082", 0},
                               {"owned.48989", 0},
                               {"owned.55615", 0},
                               {"owned.15462", 0},
                               {"owned.32526", 0},
                               {"rounds", 0}});
  EXPECT_FALSE(solved.report["buildable"].get<bool>());
  ASSERT_EQ(solved.report["missing"].size(), 1U);
  const json& missing = solved.report["missing"][0];
  EXPECT_EQ(missing["part"], "2780");
  EXPECT_EQ(missing["owned"], 1);
  EXPECT_EQ(missing["needed"], solved.count("2780"));
  const json problems = solved.report["problems"];
  EXPECT_TRUE(std::any_of(problems.begin(), problems.end(), [](const json& problem) {
    const std::string message = problem["message"];
    return problem["kind"] == "owned" && message.find("2780") != std::string::npos &&
           message.find("missing") != std::string::npos;
  })) << problems;
}

TEST(OwnedParts, AreCountedOnTheModelAlone) {
  Settings settings;
  settings.owned = {{"2780", 2}, {"6558", 0}};
  model::Model model;
  model.parts.resize(3);
  for (model::PlacedPart& part : model.parts) {
    part.part = "2780";
  }
  const std::vector<MissingPart> missing = missingParts(model, settings);
  ASSERT_EQ(missing.size(), 1U);
  EXPECT_EQ(missing[0].needed, 3);
  EXPECT_EQ(missing[0].owned, 2);
}

TEST(OwnedParts, LeaveLengthsOutThatNeedMoreThanThereAre) {
  // A beam of six holes is two thin ones, 32063.
  const base::Result<Settings> settings = readSettings(R"({"set": {"owned.32063": 1}})");
  ASSERT_TRUE(settings.ok());
  const std::vector<int>& lengths = settings.value().annealing.lengths;
  EXPECT_EQ(std::find(lengths.begin(), lengths.end(), 6), lengths.end());
}

struct BadOwned {
  const char* text;
  const char* names;
};

struct RefusedOwned : ::testing::TestWithParam<BadOwned> {};

TEST_P(RefusedOwned, AreNamed) {
  const base::Result<Settings> settings = readSettings(GetParam().text);
  ASSERT_FALSE(settings.ok());
  EXPECT_NE(settings.error().message.find(GetParam().names), std::string::npos)
      << settings.error().message;
}

INSTANTIATE_TEST_SUITE_P(
    All,
    RefusedOwned,
    ::testing::Values(BadOwned{R"({"set": {"owned.nothing": 1}})", "owned.nothing"},
                      BadOwned{R"({"set": {"owned.2780": -1}})", "owned.2780"},
                      BadOwned{R"({"set": {"owned.2780": 1.5}})", "owned.2780"},
                      BadOwned{R"({"set": {"owned.2780": "some"}})", "owned.2780"},
                      BadOwned{R"({"set": {"owned.2780": 0}})", "owned.2780"},
                      BadOwned{R"({"set": {"lengths": "9", "owned.40490": 0}})", "owned"}));

}  // namespace
}  // namespace liftarm::design
