#include "analysis/joint_motion.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/kinematic_chain.h"
#include "analysis/motion.h"
#include "core/helpers/models.h"

namespace liftarm::analysis {
namespace {

using lattice::Vec3;
using model::Model;
using testing::beamAt;
using testing::kX;
using testing::kY;
using testing::kZ;
using testing::pinAt;

//! A scene with what it refers to.
struct Stage {
  explicit Stage(Model source)
      : model(std::move(source)),
        scene(makeScene(model, parts::Catalogue::builtIn())),
        coverage(findCoverage(scene)) {}

  Model model;
  Scene scene;
  std::vector<EdgeCover> coverage;
};

JointMotion turned(const Stage& stage, int joint = 0) {
  return JointMover(stage.scene, stage.coverage).turnJoint(joint);
}

const std::string kJointAtOrigin = R"(,"joints":[{"at":[0,0,0],"axis":[0,0,1]}])";

//! Two beams on one free pin, one above the other.
Model hinge() {
  Model model;
  model.parts = {beamAt("40490", {4, 0, 0}, kX, kZ),
                 beamAt("40490", {0, 4, 1}, kY, kZ),
                 pinAt("3673", {0, 0, 0.5}, kZ)};
  model.sketchJson =
      testing::sketchOf({{{0, 0, 0}, {8, 0, 0}}, {{0, 0, 0}, {0, 8, 0}}}, kJointAtOrigin);
  return model;
}

//! A hinge with a peg in the way: a pin stands up from the lower beam.
Model hingeWithPeg() {
  Model model = hinge();
  model.parts.push_back(pinAt("2780", {5, 0, 0.5}, kZ));
  return model;
}

//! The square with free pins and a joint in one corner: it moves as a parallelogram.
Model foldingSquare() {
  Model model = testing::squareFrame();
  for (std::size_t i = 4; i < 8; ++i) {
    model.parts[i].part = "3673";
  }
  model.sketchJson.pop_back();
  model.sketchJson += kJointAtOrigin + "}";
  return model;
}

//! Crank, coupler and rocker on a ground beam along x, each in its own layer. Sides: ground 8,
//! crank 2, coupler 8, rocker 6: by Grashof's rule the shortest goes round.
Model crankAndRocker() {
  Model model;
  const double rockerX = 8.0;
  // The crank's far pin at angle 90 degrees: (0, 2); the rocker's end R: |R - (8,0)| = 6, |R -
  // (0,2)| = 8.
  const double dx = rockerX;
  const double dy = -2.0;
  const double d = std::sqrt(dx * dx + dy * dy);
  const double a = (8.0 * 8.0 - 6.0 * 6.0 + d * d) / (2 * d);
  const double h = std::sqrt(8.0 * 8.0 - a * a);
  const Vec3 end{a * dx / d - h * dy / d, 2.0 + a * dy / d + h * dx / d, 0};
  const Vec3 along = lattice::normalized(end - Vec3{0, 2, 0});
  const Vec3 rocker = lattice::normalized(end - Vec3{rockerX, 0, 0});
  const Vec3 middle = 0.5 * (end + Vec3{0, 2, 0});
  const Vec3 rockerMiddle = 0.5 * (end + Vec3{rockerX, 0, 0});
  model.parts = {beamAt("40490", {4, 0, 0}, kX, kZ),
                 beamAt("32523", {0, 1, 1}, kY, kZ),
                 beamAt("40490", {middle.x, middle.y, 2}, along, kZ),
                 beamAt("32524", {rockerMiddle.x, rockerMiddle.y, 1}, rocker, kZ),
                 pinAt("3673", {0, 0, 0.5}, kZ),
                 pinAt("3673", {0, 2, 1.5}, kZ),
                 pinAt("3673", {end.x, end.y, 1.5}, kZ),
                 pinAt("3673", {rockerX, 0, 0.5}, kZ)};
  model.sketchJson =
      testing::sketchOf({{{0, 0, 0}, {8, 0, 0}}, {{0, 0, 0}, {0, 2, 0}}}, kJointAtOrigin);
  return model;
}

TEST(JointMotion, FreeHingeTurnsAllTheWayRound) {
  const Stage stage(hinge());
  const JointMotion motion = turned(stage);
  EXPECT_TRUE(motion.range.turns);
  EXPECT_EQ(motion.range.from.degrees, -180);
  EXPECT_EQ(motion.range.to.degrees, 180);
}

TEST(JointMotion, PegStopsTheHinge) {
  const Stage stage(hingeWithPeg());
  const RangeEnd from = turned(stage).range.from;
  // The beam of half width 0.45 meets the pin's collar of radius 0.4 five modules out.
  const double contact = std::asin((0.45 + 0.4) / 5.0) * 180 / M_PI;
  EXPECT_NEAR(from.degrees, -(90 - contact), 0.5);
  EXPECT_EQ(from.stoppedBy, (std::vector<int>{1, 3}));
}

TEST(JointMotion, StopIsMirroredWithTheModel) {
  Model model = hingeWithPeg();
  model.parts[1] = beamAt("40490", {0, -4, 1}, -kY, kZ);
  model.sketchJson =
      testing::sketchOf({{{0, 0, 0}, {8, 0, 0}}, {{0, 0, 0}, {0, -8, 0}}}, kJointAtOrigin);
  const Stage mirrored(model);
  const Stage stage(hingeWithPeg());
  EXPECT_NEAR(turned(mirrored).range.to.degrees, -turned(stage).range.from.degrees, 1e-6);
}

TEST(JointMotion, HeavierPartsElsewhereChangeNothing) {
  Model model = hingeWithPeg();
  model.parts.push_back(beamAt("32278", {0, 40, 0}, kX, kZ));
  const Stage apart(model);
  const Stage stage(hingeWithPeg());
  EXPECT_NEAR(turned(apart).range.from.degrees, turned(stage).range.from.degrees, 0.5);
  EXPECT_NEAR(turned(apart).range.to.degrees, turned(stage).range.to.degrees, 0.5);
}

TEST(JointMotion, DriverThatHangsOnNothingMovesNothing) {
  Linkage linkage;
  linkage.bodies = 4;
  Link driver;
  driver.a = 2;
  driver.b = 3;
  driver.axis = kZ;
  KinematicChain chain(linkage, driver, 0);
  EXPECT_FALSE(chain.moveTo(0.1));
}

TEST(JointMotion, SidesThatAreApartAreSaidToBe) {
  Model model = hinge();
  model.parts.pop_back();
  const Stage stage(model);
  EXPECT_NE(turned(stage).range.message.find("are not connected"), std::string::npos);
}

TEST(JointMotion, AxleThroughTwoRailsTurnsInBoth) {
  Model model = testing::frameOfAxles();
  model.sketchJson.pop_back();
  model.sketchJson += R"(,"joints":[{"at":[0,0,0],"axis":[0,1,0],"between":[[0],[2]]}]})";
  const Stage stage(model);
  const JointRange range = turned(stage).range;
  EXPECT_TRUE(range.turns) << range.message;
  EXPECT_EQ(range.to.degrees, 180);
}

TEST(JointMotion, SecondPinMakesItStiff) {
  Model model = hinge();
  model.parts[1] = beamAt("40490", {4, 0, 1}, kX, kZ);
  model.parts.push_back(pinAt("3673", {8, 0, 0.5}, kZ));
  model.sketchJson =
      testing::sketchOf({{{0, 0, 0}, {4, 0, 0}}, {{0, 0, 0}, {0, 4, 0}}}, kJointAtOrigin);
  const Stage stage(model);
  EXPECT_FALSE(turned(stage).range.turns);
  EXPECT_FALSE(turned(stage).range.message.empty());
}

TEST(JointMotion, SquareMovesAsAParallelogram) {
  const Stage stage(foldingSquare());
  const JointMotion motion = turned(stage);
  ASSERT_TRUE(motion.range.turns);
  ASSERT_GE(motion.path.parts.size(), 3U);
  for (const auto& poses : motion.path.poses) {
    for (std::size_t i = 0; i < poses.size(); ++i) {
      // Beams 0 and 1 lie along x and stay parallel: so do 2 and 3.
      const int part = motion.path.parts[i];
      for (std::size_t j = 0; j < poses.size(); ++j) {
        if (part / 2 == motion.path.parts[j] / 2 && part < 4) {
          const Vec3 p = poses[i].rotation * kY;
          const Vec3 q = poses[j].rotation * kY;
          EXPECT_LT(lattice::length(lattice::cross(p, q)), 1e-6);
        }
      }
    }
  }
}

TEST(JointMotion, CrankGoesRound) {
  const Stage stage(crankAndRocker());
  const JointMotion motion = turned(stage);
  EXPECT_EQ(motion.range.from.degrees, -180) << motion.range.message;
  EXPECT_EQ(motion.range.to.degrees, 180) << motion.range.message;
}

//! Distance between the places of a hole of each of two parts at a key; parts that rest are where
//! they were.
double apart(const Stage& stage,
             const MotionPath& path,
             std::size_t key,
             std::pair<int, int> parts) {
  const auto pose = [&](int part) {
    for (std::size_t i = 0; i < path.parts.size(); ++i) {
      if (path.parts[i] == part) {
        return path.poses[key][i];
      }
    }
    return stage.model.parts[static_cast<std::size_t>(part)].pose;
  };
  // The pin's own middle, in the frame of the other part at the start, followed.
  const lattice::Pose& pin = stage.model.parts[static_cast<std::size_t>(parts.first)].pose;
  const lattice::Pose& other = stage.model.parts[static_cast<std::size_t>(parts.second)].pose;
  const Vec3 local = lattice::transposed(other.rotation) * (pin.position - other.position);
  return lattice::length(pose(parts.first).position - pose(parts.second).apply(local));
}

TEST(JointMotion, LoopStaysClosedAllTheWay) {
  const Stage stage(crankAndRocker());
  const MotionPath path = turned(stage).path;
  for (std::size_t key = 0; key < path.poses.size(); ++key) {
    for (const auto& parts : std::vector<std::pair<int, int>>{
             {4, 0}, {4, 1}, {5, 1}, {5, 2}, {6, 2}, {6, 3}, {7, 3}, {7, 0}}) {
      EXPECT_LT(apart(stage, path, key, parts), 1e-6) << "key " << key;
    }
  }
}

TEST(JointMotion, RockerComesToADeadPoint) {
  Model model = crankAndRocker();
  model.sketchJson =
      testing::sketchOf({{{0, 0, 0}, {8, 0, 0}}}, R"(,"joints":[{"at":[8,0,0],"axis":[0,0,1]}])");
  const Stage stage(model);
  // The rocker lies on no line of the sketch: its motion is the free one of the model.
  const JointMover mover(stage.scene, stage.coverage);
  ASSERT_EQ(mover.free().internal, 1);
  EXPECT_TRUE(mover.follow(0).range.turns);
}

TEST(JointMotion, KeysRiseFromOneEndToTheOther) {
  const Stage stage(hingeWithPeg());
  const JointMotion motion = turned(stage);
  EXPECT_EQ(motion.path.degrees.front(), motion.range.from.degrees);
  EXPECT_EQ(motion.path.degrees.back(), motion.range.to.degrees);
  EXPECT_TRUE(std::is_sorted(motion.path.degrees.begin(), motion.path.degrees.end()));
}

TEST(JointMotion, StiffJointIsAProblemOfItemSeven) {
  Model model = hinge();
  model.parts[2].part = "99999";
  const Stage stage(model);
  const ItemResult item = checkJoints(stage.scene, analyseMotion(stage.scene, stage.coverage));
  ASSERT_EQ(item.problems.size(), 1U);
  EXPECT_EQ(item.problems[0].kind, "joint");
}

}  // namespace
}  // namespace liftarm::analysis
