// What a sketch keeps, from its text to the model.

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "design/attempt.h"
#include "design/design_session.h"
#include "design/keep_blame.h"
#include "design/part_places.h"
#include "sketch/keep_json.h"
#include "sketch/sketch_json.h"

namespace liftarm::design {
namespace {

using nlohmann::json;

constexpr std::uint32_t kKeepSlice = 100'000;

//! A portal: two posts, a beam across their tops, and a brace.
json portal() {
  return json::parse(R"({"format": "technic-sketch", "version": 2, "lines": [
    {"from": [0, 0, 0], "to": [0, 0, 8]}, {"from": [8, 0, 0], "to": [8, 0, 8]},
    {"from": [0, 0, 8], "to": [8, 0, 8]}, {"from": [0, 0, 5], "to": [4, 0, 8]},
    {"from": [0, 0, 0], "to": [8, 0, 0]}]})");
}

struct KeptDesign {
  json model;
  json report;
  json places;
  std::string layout;
};

KeptDesign solveKept(const json& sketch, json settings = {{"seed", 1}}) {
  auto created = DesignSession::create(sketch.dump(), settings.dump());
  EXPECT_TRUE(created.ok());
  const std::unique_ptr<DesignSession> session = std::move(created).value();
  while (!session->advance(kKeepSlice)) {
  }
  const std::string model = session->modelJson();
  const std::string layout = session->layoutJson();
  settings.erase("earlier");
  const auto places = partPlacesJson(model, layout, settings.dump());
  EXPECT_TRUE(places.ok());
  return {json::parse(model),
          json::parse(session->reportJson()),
          json::parse(places.value()).at("places"),
          layout};
}

bool has(const json& places, const json& place) {
  return std::find(places.begin(), places.end(), place) != places.end();
}

//! The first place of a part on this line.
json placeOn(const json& places, int line) {
  const auto found = std::find_if(places.begin(), places.end(), [&](const json& place) {
    return !place.is_null() && place.at("line") == line;
  });
  return found == places.end() ? json() : *found;
}

json keeping(json sketch, const json& place) {
  sketch["keep"] = json::array({{{"line", place.at("line")}, {"parts", {place.at("part")}}}});
  return sketch;
}

TEST(Keep, EveryBeamHasAPlaceAndNoPinHasOne) {
  const KeptDesign solved = solveKept(portal());
  for (std::size_t i = 0; i < solved.places.size(); ++i) {
    const bool beam = solved.model.at("parts")[i].at("component").get<int>() >= 0;
    EXPECT_EQ(solved.places[i].is_null(), !beam) << solved.model.at("parts")[i].at("part");
  }
}

TEST(Keep, TheLongestBeamHasAPlace) {
  const KeptDesign solved =
      solveKept(json::parse(R"({"format": "technic-sketch", "version": 1, "lines": [
    {"from": [0, 0, 0], "to": [14, 0, 0]}]})"));
  EXPECT_EQ(placeOn(solved.places, 0).at("part").at("to"), 14);
}

TEST(Keep, AKeptPartStaysForAnotherSeed) {
  const KeptDesign first = solveKept(portal());
  const json place = placeOn(first.places, 2);
  const KeptDesign second = solveKept(keeping(portal(), place), {{"seed", 5}});
  EXPECT_TRUE(has(second.places, place));
  EXPECT_TRUE(second.report.at("buildable").get<bool>());
}

TEST(Keep, AKeptPartStaysWhereTheSearchWouldNotLayIt) {
  const json place = {
      {"line", 2},
      {"part", {{"part", "32524"}, {"from", 1}, {"to", 7}, {"layer", 2}, {"holeAxis", "y"}}}};
  const KeptDesign solved = solveKept(keeping(portal(), place));
  EXPECT_TRUE(has(solved.places, place));
}

TEST(Keep, ABarredPartLiesElsewhere) {
  const KeptDesign first = solveKept(portal());
  const json place = placeOn(first.places, 2);
  json barred = place.at("part");
  for (const char* key : {"layer", "holeAxis", "with"}) {
    barred.erase(key);
  }
  json sketch = portal();
  sketch["keep"] = json::array({{{"line", 2}, {"barred", {barred}}}});
  const KeptDesign second =
      solveKept(sketch, {{"seed", 1}, {"earlier", json::parse(first.layout)}});
  EXPECT_FALSE(has(second.places, place));
  EXPECT_TRUE(second.report.at("buildable").get<bool>());
}

TEST(Keep, BeamsLieOnTheLayersOfTheirLine) {
  json sketch = portal();
  sketch["keep"] = json::array({{{"line", 2}, {"layers", {1, 2}}}});
  const KeptDesign solved = solveKept(sketch);
  EXPECT_GE(placeOn(solved.places, 2).at("part").at("layer").get<int>(), 1);
  EXPECT_TRUE(solved.report.at("buildable").get<bool>());
}

TEST(Keep, BeamsEndWhereALineIsSplit) {
  json sketch = portal();
  sketch["keep"] = json::array({{{"line", 4}, {"splits", {4}}}});
  const KeptDesign solved = solveKept(sketch);
  for (const json& place : solved.places) {
    if (!place.is_null() && place.at("line") == 4) {
      const json& part = place.at("part");
      EXPECT_TRUE(part.at("from") >= 3 || part.at("to") <= 5) << place;
    }
  }
}

TEST(Keep, WhatIsKeptComesBackInTheModelsSketch) {
  const KeptDesign first = solveKept(portal());
  const json sketch = keeping(portal(), placeOn(first.places, 2));
  const KeptDesign second = solveKept(sketch);
  EXPECT_EQ(second.model.at("sketch").at("keep"), sketch.at("keep"));
}

TEST(Keep, APartThatDoesNotFitItsPlaceIsNamed) {
  const json place = {
      {"line", 2},
      {"part", {{"part", "32524"}, {"from", 0}, {"to", 8}, {"layer", 0}, {"holeAxis", "y"}}}};
  const KeptDesign solved = solveKept(keeping(portal(), place));
  const json& problem = solved.report.at("problems").at(0);
  EXPECT_EQ(problem.at("kind"), "keep");
  EXPECT_EQ(problem.at("line"), 2);
  EXPECT_EQ(problem.at("at"), json::parse("[4.0, 0.0, 8.0]"));
  EXPECT_FALSE(solved.report.at("buildable").get<bool>());
}

TEST(Keep, ALineWithoutItsKeptPartIsNamed) {
  const json place = {
      {"line", 2},
      {"part", {{"part", "32524"}, {"from", 1}, {"to", 7}, {"layer", 0}, {"holeAxis", "y"}}}};
  const std::string text = keeping(portal(), place).dump();
  const auto sketch = sketch::readSketch(text);
  ASSERT_TRUE(sketch.ok());
  Settings settings;
  settings.keeps = sketch::keepsOf(text, sketch.value());
  const layout::LayoutProblem problem = problemOf(sketch.value(), settings);
  const std::vector<layout::Cover> bare(problem.graph.runs.size());
  const std::vector<layout::KeepFault> faults = findUnkept(sketch.value(), problem, bare);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults.front().line, 2);
}

TEST(Keep, TwoPartsInOnePlaceAreNamed) {
  json sketch = portal();
  const auto part = [](const char* id, int from, int to) {
    return json{{"part", id}, {"from", from}, {"to", to}, {"layer", 0}, {"holeAxis", "y"}};
  };
  sketch["keep"] =
      json::array({{{"line", 2}, {"parts", {part("32524", 0, 6), part("32316", 4, 8)}}}});
  EXPECT_EQ(solveKept(sketch).report.at("problems").at(0).at("message"),
            "another part is kept where this one is");
}

TEST(Keep, TheMethodOfThePaperKnowsNone) {
  const KeptDesign first = solveKept(portal());
  const json sketch = keeping(portal(), placeOn(first.places, 2));
  EXPECT_FALSE(DesignSession::create(sketch.dump(), R"({"method": "paper"})").ok());
}

TEST(Keep, WhatElseFitsIsOfferedOnTheSameStretch) {
  const KeptDesign solved = solveKept(portal());
  const json place = placeOn(solved.places, 2);
  const auto index = std::find(solved.places.begin(), solved.places.end(), place);
  const auto answer = fittingPartsJson(solved.model.dump(),
                                       solved.layout,
                                       R"({"seed": 1})",
                                       static_cast<int>(index - solved.places.begin()));
  ASSERT_TRUE(answer.ok());
  const json fits = json::parse(answer.value());
  EXPECT_FALSE(has(fits.at("fits"), place));
  EXPECT_GT(fits.at("fits").size(), 2U);
  EXPECT_EQ(fits.at("layers").size(), 4U);
}

TEST(Keep, APartHasAColourOfItsOwn) {
  const KeptDesign first = solveKept(portal());
  const json& part = first.model.at("parts").at(0);
  json sketch = portal();
  sketch["colours"] = {
      {"parts", {{{"part", part.at("part")}, {"at", part.at("position")}, {"colour", 5}}}}};
  const KeptDesign second = solveKept(sketch);
  EXPECT_EQ(second.model.at("parts").at(0).at("color"), 5);
  EXPECT_NE(second.model.at("parts").at(1).at("color"), 5);
}

}  // namespace
}  // namespace liftarm::design
