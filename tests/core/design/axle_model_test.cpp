#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/joint_motion.h"
#include "analysis/scene.h"
#include "core/helpers/sketches.h"
#include "core/helpers/solved.h"
#include "design/design_session.h"
#include "layout/axle.h"
#include "model/model_json.h"
#include "sketch/sketch_json.h"

namespace liftarm::design {
namespace {

using lattice::Vec3;
using nlohmann::json;
using testing::solve;
using testing::Solved;

//! Two long lines with a post at either end, joined by two lines of this length between the posts'
//! tops.
sketch::Sketch railsSketch(double apart) {
  testing::Segments lines;
  for (const double y : {0.0, apart}) {
    lines.push_back({{0, y, 0}, {10, y, 0}});
    lines.push_back({{0, y, 0}, {0, y, 6}});
    lines.push_back({{10, y, 0}, {10, y, 6}});
  }
  lines.push_back({{0, 0, 6}, {0, apart, 6}});
  lines.push_back({{10, 0, 6}, {10, apart, 6}});
  return testing::sketchFrom(lines);
}

//! Two squares side by side, with a line from the middle of each side to that of the other's.
sketch::Sketch squaresSketch(double apart) {
  testing::Segments lines;
  for (const double y : {0.0, apart}) {
    lines.push_back({{0, y, 0}, {8, y, 0}});
    lines.push_back({{8, y, 0}, {8, y, 8}});
    lines.push_back({{8, y, 8}, {0, y, 8}});
    lines.push_back({{0, y, 8}, {0, y, 0}});
  }
  for (const Vec3 middle : {Vec3{4, 0, 0}, Vec3{8, 0, 4}, Vec3{4, 0, 8}, Vec3{0, 0, 4}}) {
    lines.push_back({middle, middle + Vec3{0, apart, 0}});
  }
  return testing::sketchFrom(lines);
}

//! Legs through rails at three heights.
sketch::Sketch legsSketch() {
  testing::Segments lines{{{0, 0, 0}, {0, 0, 8}}, {{8, 0, 0}, {8, 0, 8}}};
  for (const double z : {2.0, 5.0, 8.0}) {
    lines.push_back({{0, 0, z}, {8, 0, z}});
  }
  sketch::Sketch sketch = testing::sketchFrom(lines);
  sketch.ground = 0.0;
  return sketch;
}

//! A fork with a line from side to side, about which a square turns against it.
sketch::Sketch wheelSketch() {
  sketch::Sketch sketch = testing::sketchFrom({{{0, 0, 0}, {0, 0, 6}},
                                               {{0, 6, 0}, {0, 6, 6}},
                                               {{0, 0, 0}, {6, 0, 0}},
                                               {{6, 0, 0}, {6, 6, 0}},
                                               {{0, 6, 0}, {6, 6, 0}},
                                               {{0, 0, 6}, {0, 6, 6}},
                                               {{0, 3, 6}, {4, 3, 6}},
                                               {{4, 3, 6}, {4, 3, 10}},
                                               {{4, 3, 10}, {0, 3, 10}},
                                               {{0, 3, 10}, {0, 3, 6}}});
  sketch.joints.push_back({{0, 3, 6}, {0, 1, 0}, {{5}, {6, 9}}});
  return sketch;
}

//! LDraw numbers of the axles in a model.
std::vector<std::string> axlesOf(const model::Model& model) {
  std::vector<std::string> axles;
  for (const model::PlacedPart& part : model.parts) {
    if (layout::axlePartIndex(part.part) >= 0) {
      axles.push_back(part.part);
    }
  }
  return axles;
}

struct Case {
  const char* name;
  sketch::Sketch sketch;
};

std::vector<Case> cases() {
  return {{"shortRails", railsSketch(2)},
          {"rails", railsSketch(3)},
          {"squares", squaresSketch(3)},
          {"legs", legsSketch()},
          {"bar", testing::sketchFrom({{{0, 0, 0}, {8, 0, 0}}, {{4, 0, 0}, {4, 0, 5}}})},
          {"wheel", wheelSketch()},
          {"cube", testing::cubeSketch(4)},
          {"house", testing::houseSketch()}};
}

struct AxleModel : ::testing::TestWithParam<std::tuple<Case, int>> {};

TEST_P(AxleModel, IsBuildableAndNoAxleSlides) {
  const Solved solved =
      solve(std::get<0>(GetParam()).sketch, json::object(), std::get<1>(GetParam()));
  EXPECT_TRUE(solved.report["buildable"].get<bool>()) << solved.report["problems"];
  const analysis::Scene scene = analysis::makeScene(solved.model, parts::Catalogue::builtIn());
  for (const model::Connection& c : scene.connections) {
    EXPECT_TRUE(model::isGood(c.fit) && c.fit != model::Fit::kSlide);
  }
}

TEST_P(AxleModel, HasNoMorePartsOrBeamsThanWithoutAxles) {
  const auto& [named, seed] = GetParam();
  if (!named.sketch.joints.empty()) {
    return;  // about its own line: there is no model without
  }
  const Solved with = solve(named.sketch, json::object(), seed);
  const Solved without = solve(named.sketch, {{"search.axles", 0}}, seed);
  EXPECT_EQ(without.report["axles"].get<int>(), 0);
  EXPECT_LE(with.report["beams"].get<int>(), without.report["beams"].get<int>());
  EXPECT_LE(with.report["bricks"].get<int>(), without.report["bricks"].get<int>());
  EXPECT_LE(with.report["freedomsHeld"].get<int>(), without.report["freedomsHeld"].get<int>());
  if (with.report["axles"].get<int>() == 0) {
    EXPECT_EQ(with.text, without.text) << "trials that came to nothing leave no trace";
  }
}

INSTANTIATE_TEST_SUITE_P(Sketches,
                         AxleModel,
                         ::testing::Combine(::testing::ValuesIn(cases()),
                                            ::testing::Values(1, 2, 3)),
                         [](const auto& test) {
                           return std::get<0>(test.param).name +
                                  std::to_string(std::get<1>(test.param));
                         });

TEST(AxleModels, ChooseAxlesForLinesBetweenParallelFrames) {
  for (const sketch::Sketch& sketch : {railsSketch(2), railsSketch(3)}) {
    const Solved solved = solve(sketch);
    EXPECT_EQ(solved.report["axles"].get<int>(), 2);
    EXPECT_EQ(axlesOf(solved.model).size(), 2U);
    const Solved without = solve(sketch, {{"search.axles", 0}});
    EXPECT_EQ(solved.report["beams"].get<int>() + 2, without.report["beams"].get<int>());
  }
}

TEST(AxleModels, HaveNoneWithABareEnd) {
  testing::Segments lines;
  for (const double y : {0.0, 3.0}) {
    lines.push_back({{0, y, 0}, {10, y, 0}});
    lines.push_back({{0, y, 0}, {0, y, 6}});
  }
  lines.push_back({{4, 0, 0}, {4, 3, 0}});
  EXPECT_EQ(solve(testing::sketchFrom(lines)).report["axles"].get<int>(), 0);
}

TEST(AxleModels, HaveNoneWhereTheSettingsSaySo) {
  for (const json& set : {json{{"search.axles", 0}},
                          json{{"axles", ""}},
                          json{{"owned.3713", 0}},
                          json{{"connectors", "2780,6558,87082,48989,55615"}}}) {
    const Solved solved = solve(railsSketch(3), set);
    EXPECT_EQ(solved.report["axles"].get<int>(), 0) << set;
    EXPECT_TRUE(solved.report["buildable"].get<bool>()) << set;
  }
}

TEST(AxleModels, UseAxlesThatAreOwnedAndNoOthers) {
  json none = json::object();
  for (const layout::AxlePart& axle : layout::axleParts()) {
    none["owned." + axle.part] = 0;
  }
  EXPECT_TRUE(axlesOf(solve(railsSketch(3), none).model).empty());

  const Solved whole = solve(railsSketch(3));
  ASSERT_EQ(whole.report["axles"].get<int>(), 2);
  const std::string used = axlesOf(whole.model).front();
  none["owned." + used] = 1;
  const Solved one = solve(railsSketch(3), none);
  EXPECT_EQ(one.report["axles"].get<int>(), 1) << "alone, where its family has too few";
  EXPECT_TRUE(one.report["missing"].empty());
  EXPECT_TRUE(one.report["buildable"].get<bool>());

  for (const std::string& id : axlesOf(solve(railsSketch(3), {{"axles", used}}).model)) {
    EXPECT_EQ(id, used);
  }
}

TEST(AxleModels, LayAnAxleWhereAJointTurnsAboutItsOwnLine) {
  EXPECT_FALSE(solve(wheelSketch(), {{"search.axles", 0}}).report["buildable"].get<bool>());
  const Solved solved = solve(wheelSketch());
  EXPECT_TRUE(solved.report["buildable"].get<bool>()) << solved.report["problems"];
  EXPECT_EQ(solved.report["axles"].get<int>(), 1);
  EXPECT_EQ(solved.report["freedomsHeld"].get<int>(), 1) << "nothing but the wheel turns";
  const analysis::Scene scene = analysis::makeScene(solved.model, parts::Catalogue::builtIn());
  const analysis::JointMover mover(scene, analysis::findCoverage(scene));
  ASSERT_EQ(mover.joints(), 1);
  EXPECT_TRUE(mover.turnJoint(0).range.turns);
}

TEST(AxleModels, AreTheSameForTheSameSeedHoweverTheSearchIsCutUp) {
  const Solved once = solve(squaresSketch(3), json::object(), 2);
  auto session = DesignSession::create(sketch::writeSketch(squaresSketch(3)),
                                       R"({"seed": 2, "preset": "simple"})");
  ASSERT_TRUE(session.ok());
  while (!session.value()->advance(7)) {
  }
  EXPECT_EQ(session.value()->modelJson(), once.text);
}

TEST(AxleModels, KeepTheirAxlesAfterAnEdit) {
  auto first = DesignSession::create(sketch::writeSketch(railsSketch(3)),
                                     R"({"seed": 1, "preset": "simple"})");
  ASSERT_TRUE(first.ok());
  while (!first.value()->advance(1000)) {
  }
  sketch::Sketch edited = railsSketch(3);
  edited.lines.push_back(testing::sketchFrom({{{5, 0, 0}, {5, 0, 5}}}).lines.front());
  const json settings{
      {"seed", 1}, {"preset", "simple"}, {"earlier", json::parse(first.value()->layoutJson())}};
  auto second = DesignSession::create(sketch::writeSketch(edited), settings.dump());
  ASSERT_TRUE(second.ok()) << second.error().message;
  while (!second.value()->advance(1000)) {
  }
  const json report = json::parse(second.value()->reportJson());
  EXPECT_TRUE(report["buildable"].get<bool>()) << report["problems"];
  EXPECT_GE(report["axles"].get<int>(), 2);
}

}  // namespace
}  // namespace liftarm::design
