#include <memory>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/helpers/models.h"
#include "core/helpers/sketches.h"
#include "core/helpers/solved.h"
#include "design/design_session.h"
#include "sketch/sketch_json.h"

namespace liftarm::design {
namespace {

using nlohmann::json;

const char* const kQuick = R"({"seed": 3, "set": {"effort": 0.2, "starts": 10}})";

std::unique_ptr<DesignSession> sessionOf(const sketch::Sketch& sketch,
                                         const std::string& settings = kQuick) {
  auto session = DesignSession::create(sketch::writeSketch(sketch), settings);
  EXPECT_TRUE(session.ok()) << (session.ok() ? "" : session.error().message);
  return session.ok() ? std::move(session).value() : nullptr;
}

std::unique_ptr<DesignSession> finished(const sketch::Sketch& sketch) {
  std::unique_ptr<DesignSession> session = sessionOf(sketch);
  while (!session->advance(500)) {
  }
  return session;
}

TEST(DesignSession, RefusesABadSketchWithItsMessage) {
  const auto session = DesignSession::create(testing::sketchOf({{{0, 0, 0}, {4.5, 0, 0}}}), "");
  ASSERT_FALSE(session.ok());
  const auto sketch = sketch::readSketch(testing::sketchOf({{{0, 0, 0}, {4.5, 0, 0}}}));
  ASSERT_FALSE(sketch.ok());
  EXPECT_EQ(session.error().message, sketch.error().message);
}

TEST(DesignSession, SaysWhichLineNoBeamsMakeUp) {
  // Four holes, no overlap and nothing beside the line: no beam has them all round.
  sketch::Sketch sketch = testing::lineSketch(3);
  sketch.lines.front().exact = true;
  const json report = json::parse(finished(sketch)->reportJson());
  EXPECT_FALSE(report["buildable"].get<bool>());
  std::string messages;
  for (const json& problem : report["problems"]) {
    messages += problem["kind"] == "line" ? problem["message"].get<std::string>() : "";
  }
  EXPECT_NE(messages.find("3 modules of the line from here: on an exact line"), std::string::npos)
      << report["problems"];
}

TEST(DesignSession, RefusesBadSettingsWithTheirMessage) {
  const auto session = DesignSession::create(sketch::writeSketch(testing::squareSketch(8)),
                                             R"({"preset": "cheap"})");
  ASSERT_FALSE(session.ok());
  EXPECT_NE(session.error().message.find("cheap"), std::string::npos);
}

TEST(DesignSession, MakesAModelThatTheCheckCanRead) {
  const auto session = finished(testing::cubeSketch(6));
  const auto check = checkModelJson(session->modelJson());
  ASSERT_TRUE(check.ok()) << check.error().message;
  EXPECT_TRUE(json::parse(check.value())["buildable"].get<bool>()) << check.value();
}

TEST(DesignSession, GrowsFromTheLayoutOfAnEarlierSketch) {
  const auto first = finished(testing::cubeSketch(6));
  EXPECT_FALSE(json::parse(first->reportJson())["grown"].get<bool>());
  sketch::Sketch longer = testing::cubeSketch(6);
  longer.lines.push_back({{6, 6, 6}, {6, 6, 11}, 5, false, {}});
  json settings = json::parse(kQuick);
  settings["earlier"] = json::parse(first->layoutJson());
  const auto second = sessionOf(longer, settings.dump());
  while (!second->advance(500)) {
  }
  const json report = json::parse(second->reportJson());
  EXPECT_TRUE(report["grown"].get<bool>());
  EXPECT_TRUE(report["buildable"].get<bool>()) << report.dump();
}

TEST(DesignSession, RefusesAnEarlierLayoutThatIsNone) {
  for (const char* text : {R"({"earlier": 3})",
                           R"({"earlier": {"runs": [{}]}})",
                           R"({"earlier": {"runs": [{"from": [0, 0], "to": [1, 0, 0], "axis": 0,
                               "beams": [], "meets": []}]}})",
                           R"({"earlier": {"runs": [{"from": [0, 0, 0], "to": [1, 0, 0], "axis": 7,
                               "beams": [], "meets": []}]}})"}) {
    const auto session = DesignSession::create(sketch::writeSketch(testing::squareSketch(8)), text);
    ASSERT_FALSE(session.ok()) << text;
    EXPECT_NE(session.error().message.find("earlier"), std::string::npos);
  }
}

TEST(DesignSession, CallsBuildableWhatTheCheckCallsBuildable) {
  for (const sketch::Sketch& sketch :
       {testing::squareSketch(8), testing::cornerSketch(5), testing::triangleSketch(2)}) {
    const auto session = finished(sketch);
    const auto check = checkModelJson(session->modelJson());
    ASSERT_TRUE(check.ok());
    EXPECT_EQ(json::parse(session->reportJson())["buildable"],
              json::parse(check.value())["buildable"]);
  }
}

TEST(DesignSession, GivesTheSameBytesForTheSameInput) {
  const auto a = finished(testing::houseSketch());
  const auto b = finished(testing::houseSketch());
  EXPECT_EQ(a->modelJson(), b->modelJson());
  EXPECT_EQ(a->reportJson(), b->reportJson());
}

TEST(DesignSession, GivesAnotherSearchForAnotherSeed) {
  const auto a = sessionOf(testing::houseSketch(), R"({"seed": 1})");
  const auto b = sessionOf(testing::houseSketch(), R"({"seed": 2})");
  a->advance(50);
  b->advance(50);
  EXPECT_NE(json::parse(a->progressJson())["objective"],
            json::parse(b->progressJson())["objective"]);
}

TEST(DesignSession, CanBeAskedBeforeItsFirstStep) {
  const auto session = sessionOf(testing::squareSketch(8));
  EXPECT_EQ(json::parse(session->progressJson())["phase"], "stageOne");
  const auto check = checkModelJson(session->modelJson());
  EXPECT_TRUE(check.ok()) << check.error().message;
  EXPECT_FALSE(json::parse(session->reportJson())["buildable"].get<bool>());
}

TEST(DesignSession, ExportsItsModel) {
  const auto session = finished(testing::squareSketch(8));
  for (const char* format : {"mpd", "parts.csv"}) {
    const auto text = exportModel(session->modelJson(), format);
    ASSERT_TRUE(text.ok()) << format;
    EXPECT_FALSE(text.value().empty()) << format;
  }
  EXPECT_FALSE(exportModel(session->modelJson(), "stl").ok());
}

TEST(DesignSession, ReportsEveryProgressField) {
  const auto session = sessionOf(testing::squareSketch(8));
  session->advance(10);
  const json progress = json::parse(session->progressJson());
  for (const char* key : {"done",
                          "phase",
                          "iterations",
                          "fraction",
                          "objective",
                          "temperature",
                          "beams",
                          "gaps",
                          "collisions",
                          "failedConnections",
                          "improvements"}) {
    EXPECT_TRUE(progress.contains(key)) << key;
  }
}

TEST(DesignSession, SolvesEachPieceOfASketch) {
  sketch::Sketch sketch = testing::squareSketch(8);
  for (sketch::Line line : testing::squareSketch(6).lines) {
    line.from.z += 40;
    line.to.z += 40;
    sketch.lines.push_back(line);
  }
  const json report = json::parse(finished(sketch)->reportJson());
  EXPECT_EQ(report["pieces"], 2);
  EXPECT_TRUE(report["buildable"].get<bool>()) << report["problems"];
}

TEST(DesignSession, SolvesPiecesOfOneBeamEach) {
  const json report =
      json::parse(finished(testing::sketchFrom({{{0, 0, 0}, {6, 0, 0}}, {{0, 40, 0}, {8, 40, 0}}}))
                      ->reportJson());
  EXPECT_TRUE(report["buildable"].get<bool>()) << report["problems"];
}

TEST(DesignSession, TheRigidPresetEndsWithoutFreedoms) {
  for (const sketch::Sketch& sketch : {testing::squareSketch(8), testing::cubeSketch(8)}) {
    const auto session = sessionOf(sketch, R"({"seed": 3, "preset": "simple-rigid"})");
    while (!session->advance(500)) {
    }
    const json report = json::parse(session->reportJson());
    EXPECT_TRUE(report["buildable"].get<bool>()) << report["problems"];
    EXPECT_EQ(report["freedoms"], 0);
  }
}

TEST(DesignSession, TheSimplePresetLeavesASquareLoose) {
  const json report = testing::solve(testing::squareSketch(8)).report;
  EXPECT_GT(report["freedoms"].get<int>(), 0);
}

TEST(DesignSession, TheUsualPresetLeavesNothingLoose) {
  const json report = json::parse(finished(testing::squareSketch(8))->reportJson());
  EXPECT_EQ(report["preset"], "balanced");
  EXPECT_EQ(report["freedoms"].get<int>(), 0);
}

TEST(Report, HasTheKeysOfTheDesignButItsTimes) {
  const json report = json::parse(finished(testing::squareSketch(8))->reportJson());
  for (const char* key : {"name",
                          "seed",
                          "preset",
                          "method",
                          "lines",
                          "length",
                          "components",
                          "beams",
                          "bricks",
                          "gaps",
                          "collisions",
                          "uncovered",
                          "failedConnections",
                          "pinHeadRatio",
                          "deviation",
                          "layerRange",
                          "symmetryDeviation",
                          "buildable",
                          "problems",
                          "objective",
                          "iterations",
                          "beamsLowerBound",
                          "mass",
                          "size"}) {
    EXPECT_TRUE(report.contains(key)) << key;
  }
}

TEST(Report, HasTheKeysOfLaterWork) {
  const json report = json::parse(finished(testing::squareSketch(8))->reportJson());
  for (const char* key : {"rigidSubsets", "freedoms", "balanced", "assemblable", "filledGaps"}) {
    EXPECT_TRUE(report.contains(key)) << key;
  }
}

TEST(Report, CountsASquareOfFourBeamsAndFourPins) {
  const json report = testing::solve(testing::squareSketch(8)).report;
  EXPECT_EQ(report["beams"], 4);
  EXPECT_EQ(report["bricks"], 8);
  EXPECT_EQ(report["beamsLowerBound"], 4);
  EXPECT_EQ(report["lines"], 4);
  EXPECT_EQ(report["length"], 32);
  EXPECT_EQ(report["pinHeadRatio"], 1.0);
}

}  // namespace
}  // namespace liftarm::design
