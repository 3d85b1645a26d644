#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/helpers/frame_sketches.h"
#include "core/helpers/solved.h"
#include "design/design_session.h"
#include "model/model_json.h"
#include "sketch/sketch_json.h"

namespace liftarm::design {
namespace {

using nlohmann::json;
using testing::solve;
using testing::Solved;

int framesIn(const Solved& solved) {
  return solved.count("14720") + solved.count("64178") + solved.count("64179");
}

TEST(Frames, CoverWhatTheyAreMadeForAndAreBuildable) {
  for (const auto& [sketch, part] :
       {std::pair(testing::rectangleSketch(4, 6), std::string("64179")),
        std::pair(testing::smallHSketch(), std::string("14720")),
        std::pair(testing::ladderSketch(), std::string("64178"))}) {
    for (int seed = 1; seed <= 3; ++seed) {
      const Solved solved = solve(sketch, json::object(), seed);
      EXPECT_EQ(solved.model.parts.size(), 1U) << part;
      EXPECT_EQ(solved.count(part), 1);
      EXPECT_TRUE(solved.report["buildable"].get<bool>()) << solved.report["problems"];
      EXPECT_EQ(solved.report["beams"], 1);
    }
  }
}

TEST(Frames, TakeLegsInTheHolesAcrossTheirBars) {
  const Solved solved = solve(testing::benchSketch());
  EXPECT_EQ(solved.count("64179"), 1);
  EXPECT_EQ(solved.report["beams"], 3);
  EXPECT_TRUE(solved.report["buildable"].get<bool>()) << solved.report["problems"];
}

TEST(Frames, AreNotUsedWhenSwitchedOffOrNotOwned) {
  const sketch::Sketch rectangle = testing::rectangleSketch(4, 6);
  for (const json& set :
       {json{{"search.frames", 0}}, json{{"frames", "14720,64178"}}, json{{"owned.64179", 0}}}) {
    const Solved solved = solve(rectangle, set);
    EXPECT_EQ(framesIn(solved), 0) << set;
    EXPECT_TRUE(solved.report["buildable"].get<bool>()) << solved.report["problems"];
  }
}

TEST(Frames, NeedNoStraightBeamsOfTheLengthsOfTheirBars) {
  const Solved solved = solve(testing::ladderSketch(), {{"lengths", "3,9"}});
  EXPECT_EQ(solved.count("64178"), 1);
  EXPECT_TRUE(solved.report["buildable"].get<bool>()) << solved.report["problems"];
}

TEST(Frames, AreNotExceededWhereOthersServe) {
  sketch::Sketch two = testing::rectangleSketch(4, 6);
  for (const sketch::Line& line : testing::rectangleSketch(4, 6).lines) {
    two.lines.push_back(line);
    two.lines.back().from.z += 9.0;
    two.lines.back().to.z += 9.0;
  }
  EXPECT_EQ(solve(two).count("64179"), 2);
  const Solved limited = solve(two, {{"owned.64179", 1}});
  EXPECT_EQ(limited.count("64179"), 1);
  EXPECT_TRUE(limited.report["buildable"].get<bool>()) << limited.report["problems"];
}

TEST(Frames, AreNeverLaidAcrossAJoint) {
  sketch::Sketch linkage = testing::rectangleSketch(4, 6);
  for (const lattice::Vec3 corner : {lattice::Vec3{0, 0, 0},
                                     lattice::Vec3{4, 0, 0},
                                     lattice::Vec3{4, 6, 0},
                                     lattice::Vec3{0, 6, 0}}) {
    linkage.joints.push_back({corner, {0, 0, 1}, {}});
  }
  const Solved solved = solve(linkage);
  EXPECT_EQ(framesIn(solved), 0);
  EXPECT_TRUE(solved.report["buildable"].get<bool>()) << solved.report["problems"];
}

TEST(Frames, LockNoPartsTogether) {
  // Connectors in the holes of the rungs' frames, on two axes, hold each other there: what lies in
  // the end must come apart all the same.
  testing::Segments lines;
  for (const double y : {0.0, 3.0, 6.0}) {
    lines.push_back({{0, y, 0}, {10, y, 0}});
  }
  for (const double x : {0.0, 2.0, 4.0, 6.0, 8.0, 10.0}) {
    lines.push_back({{x, 0, 0}, {x, 6, 0}});
  }
  for (int seed = 1; seed <= 3; ++seed) {
    const Solved solved = solve(testing::sketchFrom(lines), json::object(), seed);
    EXPECT_TRUE(solved.report["buildable"].get<bool>()) << solved.report["problems"];
  }
}

TEST(Frames, AreJoinedToBeamsInLine) {
  sketch::Sketch rails = testing::sketchFrom({{{0, 0, 0}, {30, 0, 0}}, {{0, 4, 0}, {30, 4, 0}}});
  for (const double x : {0.0, 6.0, 12.0, 18.0, 24.0, 30.0}) {
    sketch::Line rung;
    rung.from = {x, 0, 0};
    rung.to = {x, 4, 0};
    rung.length = 4;
    rails.lines.push_back(rung);
  }
  const Solved with = solve(rails);
  const Solved without = solve(rails, {{"search.frames", 0}});
  EXPECT_TRUE(with.report["buildable"].get<bool>()) << with.report["problems"];
  EXPECT_GE(framesIn(with), 2);
  EXPECT_LE(with.report["beams"].get<int>() + 3, without.report["beams"].get<int>());
}

}  // namespace
}  // namespace liftarm::design
