#include "design/crowded_place.h"

#include <algorithm>
#include <cstdint>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "design/attempt.h"
#include "design/design_session.h"
#include "mechanisms/mechanism.h"
#include "sketch/sketch_json.h"

namespace liftarm::design {
namespace {

using nlohmann::json;

//! Lines of length 5 from the origin, six of them as three that go through it, in three planes.
constexpr const char* kBall = R"({"format": "technic-sketch", "version": 1, "lines": [
  {"from": [0, 0, 0], "to": [3, 4, 0]}, {"from": [0, 0, 0], "to": [-3, -4, 0]},
  {"from": [0, 0, 0], "to": [3, -4, 0]}, {"from": [0, 0, 0], "to": [-3, 4, 0]},
  {"from": [0, 0, 0], "to": [3, 0, 4]}, {"from": [0, 0, 0], "to": [-3, 0, -4]},
  {"from": [0, 0, 0], "to": [3, 0, -4]}, {"from": [0, 0, 0], "to": [-3, 0, 4]},
  {"from": [0, 0, 0], "to": [0, 3, 4]}, {"from": [0, 0, 0], "to": [0, -3, -4]},
  {"from": [0, 0, 0], "to": [0, 3, -4]}, {"from": [0, 0, 0], "to": [0, -3, 4]}]})";

//! A corner of three lines, which frames are full of.
constexpr const char* kCorner = R"({"format": "technic-sketch", "version": 1, "lines": [
  {"from": [0, 0, 0], "to": [8, 0, 0]}, {"from": [0, 0, 0], "to": [0, 8, 0]},
  {"from": [0, 0, 0], "to": [0, 0, 8]}]})";

//! Ten spokes of a wheel in one plane, and its axle.
constexpr const char* kSpokes = R"({"format": "technic-sketch", "version": 1, "lines": [
  {"from": [0, 0, 0], "to": [6, 0, 0]}, {"from": [0, 0, 0], "to": [-6, 0, 0]},
  {"from": [0, 0, 0], "to": [3, 4, 0]}, {"from": [0, 0, 0], "to": [-3, 4, 0]},
  {"from": [0, 0, 0], "to": [3, -4, 0]}, {"from": [0, 0, 0], "to": [-3, -4, 0]},
  {"from": [0, 0, 0], "to": [0, 6, 0]}, {"from": [0, 0, 0], "to": [0, 0, 6]},
  {"from": [0, 0, 0], "to": [0, -6, 0]}, {"from": [0, 0, 0], "to": [4, 3, 0]},
  {"from": [0, 0, 0], "to": [-4, 3, 0]}]})";

constexpr std::uint32_t kSlice = 1000;

sketch::Sketch read(const std::string& text) {
  base::Result<sketch::Sketch> sketch = sketch::readSketch(text);
  EXPECT_TRUE(sketch.ok());
  return std::move(sketch).value();
}

std::optional<CrowdedPlace> look(const std::string& text) {
  const sketch::Sketch sketch = read(text);
  const Settings settings;
  const Attempts attempts(sketch, settings);
  return findCrowded(sketch, {0, 0, 0}, 0.0, settings, attempts.table());
}

TEST(CrowdedPlace, LinesHaveANodeWhereTheyPassAtAWholeLength) {
  const sketch::Sketch sketch = read(R"({"format": "technic-sketch", "version": 1, "lines": [
    {"from": [0, 0, 0], "to": [8, 0, 0]}, {"from": [3, 0, 0], "to": [3, 0, 5]},
    {"from": [3, 1, 0], "to": [3, 4, 0]}]})");
  EXPECT_EQ(linesNear(sketch, {3, 0, 0}, 0.0), (std::vector<int>{0, 1}));
  EXPECT_TRUE(linesNear(sketch, {3.5, 0, 0}, 0.0).empty());
}

TEST(CrowdedPlace, AWiderPlaceHasTheLinesThatComeNear) {
  const sketch::Sketch sketch = read(R"({"format": "technic-sketch", "version": 1, "lines": [
    {"from": [0, 0, 0], "to": [8, 0, 0]}, {"from": [10, 0, 0], "to": [10, 0, 5]},
    {"from": [11, 0, 0], "to": [11, 0, 5]}]})");
  EXPECT_EQ(linesNear(sketch, {8, 0, 0}, 2.0), (std::vector<int>{0, 1}));
}

TEST(CrowdedPlace, ACornerOfThreeIsNone) {
  EXPECT_FALSE(look(kCorner).has_value());
}

TEST(CrowdedPlace, WithoutTheLinesThatItNamesTheOthersAreBuilt) {
  const std::optional<CrowdedPlace> node = look(kBall);
  ASSERT_TRUE(node.has_value());
  ASSERT_FALSE(node->without.empty());
  json sketch = json::parse(kBall);
  for (auto line = node->without.rbegin(); line != node->without.rend(); ++line) {
    sketch["lines"].erase(static_cast<std::size_t>(*line));
  }
  EXPECT_FALSE(look(sketch.dump()).has_value());
}

TEST(CrowdedPlace, WhatTheLookAtAllLinesJoinsIsBuilt) {
  const auto session = DesignSession::create(kSpokes, "");
  ASSERT_TRUE(session.ok());
  while (!session.value()->advance(kSlice)) {
  }
  EXPECT_TRUE(json::parse(session.value()->reportJson())["buildable"]);
}

TEST(CrowdedPlace, IsTheFirstProblemOfTheReportAndEndsTheSearch) {
  auto session = DesignSession::create(kBall, "");
  ASSERT_TRUE(session.ok());
  while (!session.value()->advance(kSlice)) {
  }
  const json report = json::parse(session.value()->reportJson());
  EXPECT_FALSE(report["buildable"]);
  const std::string message = report["problems"][0]["message"];
  EXPECT_EQ(message.rfind("no parts were found that join the lines which meet at [0, 0, 0]", 0), 0U)
      << message;
  const Settings settings;
  EXPECT_LT(report["iterations"],
            settings.annealing.maxRounds * std::uint64_t{settings.annealing.minIterations});
}

}  // namespace
}  // namespace liftarm::design
