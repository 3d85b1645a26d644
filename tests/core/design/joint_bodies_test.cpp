#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/helpers/sketches.h"
#include "core/helpers/solved.h"
#include "design/design_session.h"

namespace liftarm::design {
namespace {

using nlohmann::json;

//! Lines that leave the origin in the XZ plane, one a body.
sketch::Sketch fan(int bodies) {
  const testing::Segments all{{{0, 0, 0}, {6, 0, 0}},
                              {{0, 0, 0}, {0, 0, 6}},
                              {{0, 0, 0}, {-6, 0, 0}},
                              {{0, 0, 0}, {0, 0, -6}}};
  sketch::Sketch sketch =
      testing::sketchFrom({all.begin(), all.begin() + static_cast<std::ptrdiff_t>(bodies)});
  sketch.joints.push_back({{0, 0, 0}, {0, 1, 0}, {}});
  for (int line = 0; line < bodies; ++line) {
    sketch.joints[0].between.push_back({line});
  }
  return sketch;
}

json jointsOf(const testing::Solved& solved) {
  return json::parse(analyseMotionJson(solved.text).value()).at("joints");
}

TEST(JointBodies, ThreeOnOnePinTurnAgainstEachOther) {
  const testing::Solved solved = testing::solve(fan(3));
  EXPECT_TRUE(solved.report.at("buildable").get<bool>()) << solved.report.at("problems");
  const json joints = jointsOf(solved);
  ASSERT_EQ(joints.size(), 3U);
  std::vector<json> pairs;
  for (const json& row : joints) {
    EXPECT_EQ(row.at("joint"), 0);
    EXPECT_TRUE(row.at("turns").get<bool>()) << row;
    pairs.push_back(row.at("bodies"));
  }
  EXPECT_EQ(pairs, (std::vector<json>{{0, 1}, {0, 2}, {1, 2}}));
}

TEST(JointBodies, FourAreOnAnAxleBetweenStops) {
  const testing::Solved solved = testing::solve(fan(4));
  EXPECT_TRUE(solved.report.at("buildable").get<bool>()) << solved.report.at("problems");
  EXPECT_EQ(jointsOf(solved).size(), 6U);
}

TEST(JointBodies, JointsAboutOneLineShareThePin) {
  sketch::Sketch sketch = fan(3);
  sketch.joints[0].between = {{0}, {1}};
  sketch.joints.push_back({{0, 0, 0}, {0, 1, 0}, {{0}, {2}}});
  const testing::Solved solved = testing::solve(sketch);
  EXPECT_TRUE(solved.report.at("buildable").get<bool>()) << solved.report.at("problems");
  // No pin with friction holds any two of the three.
  for (const json& row : jointsOf(solved)) {
    EXPECT_TRUE(row.at("turns").get<bool>());
    EXPECT_EQ(row.at("message").get<std::string>().find("friction"), std::string::npos) << row;
  }
}

TEST(JointBodies, TheSketchOfTheReportIsReadAgain) {
  const sketch::Sketch sketch = fan(3);
  const auto again = sketch::readSketch(sketch::writeSketch(sketch));
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again.value().joints[0].between, sketch.joints[0].between);
}

std::string refusalOf(const sketch::Sketch& sketch, const std::string& settings = "{}") {
  const auto session = DesignSession::create(sketch::writeSketch(sketch), settings);
  return session.ok() ? "" : session.error().message;
}

TEST(JointRefusal, NamesTheLineThatCannotBeAnAxle) {
  sketch::Sketch mast =
      testing::sketchFrom({{{0, 0, 0}, {6, 0, 0}}, {{0, 0, 0}, {0, 0, 6}}, {{0, 0, 6}, {6, 0, 6}}});
  mast.joints = {{{0, 0, 0}, {0, 0, 1}, {{0}, {1}}}};
  EXPECT_EQ(refusalOf(mast), "");
  mast.joints.push_back({{0, 0, 6}, {0, 1, 0}, {{1}, {2}}});
  EXPECT_EQ(refusalOf(mast),
            "joints[0]: line 1 turns about itself, so it must be an axle, but line 2, which meets "
            "it at [0, 0, 6], cannot have its holes along it because of joints[1]");
}

TEST(JointRefusal, NamesTheLongestAxle) {
  const auto post = [](double height) {
    sketch::Sketch sketch = testing::sketchFrom(
        {{{0, 0, 0}, {6, 0, 0}}, {{0, 0, 0}, {0, 0, height}}, {{-3, 0, height}, {3, 0, height}}});
    sketch.joints = {{{0, 0, 0}, {0, 0, 1}, {{0}, {1}}}};
    return sketch;
  };
  EXPECT_EQ(refusalOf(post(11)), "");
  EXPECT_EQ(refusalOf(post(14)),
            "joints[0]: line 1 turns about itself, so it must be an axle, but it is 14 long and "
            "the longest axle reaches 11");
}

TEST(JointRefusal, NamesJointsAboutTwoAxesAtOnePlace) {
  sketch::Sketch cardan = testing::sketchFrom({{{-6, 0, 0}, {0, 0, 0}}, {{0, 0, 0}, {6, 0, 0}}});
  cardan.joints = {{{0, 0, 0}, {0, 1, 0}, {{0}, {1}}}, {{0, 0, 0}, {0, 0, 1}, {{0}, {1}}}};
  EXPECT_EQ(refusalOf(cardan),
            "joints[1]: lines cannot turn about two axes at [0, 0, 0], this one and that of "
            "joints[0], since no part has pin holes for both at one place; expected joints at two "
            "nodes");
}

TEST(JointRefusal, NamesAnAxisThatNoHoleIsAlong) {
  sketch::Sketch hinge = testing::sketchFrom({{{0, 0, 0}, {8, 0, 0}}, {{0, 0, 0}, {0, 0, 6}}});
  hinge.joints = {{{0, 0, 0}, {1, 1, 0}, {{0}, {1}}}};
  const std::string said =
      "joints[0].axis: [0.7071, 0.7071, 0] is not along x, y or z, and holes are; expected one of "
      "these";
  EXPECT_EQ(refusalOf(hinge), said);
  EXPECT_EQ(refusalOf(hinge, R"({"set": {"search.axles": 0}})"), said) << "whatever covers lines";
  hinge.joints[0].axis = {0.01, 1, 0};
  EXPECT_EQ(refusalOf(hinge), "") << "by so little a drawing may be off";
}

TEST(JointRefusal, NamesLinesThatLieOnEachOther) {
  sketch::Sketch sketch = testing::sketchFrom({{{0, 0, 0}, {6, 0, 0}}, {{2, 0, 0}, {-5, 0, 0}}});
  sketch.joints = {{{2, 0, 0}, {0, 1, 0}, {{0}, {1}}}};
  EXPECT_EQ(refusalOf(sketch),
            "joints[0]: lines 0 and 1 lie on each other, so they cannot turn against each other");
  sketch.lines[1].from = {0, 0, 0};
  sketch.lines[1].length = 5;
  sketch.joints[0].at = {0, 0, 0};
  EXPECT_EQ(refusalOf(sketch), "") << "end to end they are a hinge";
}

}  // namespace
}  // namespace liftarm::design
