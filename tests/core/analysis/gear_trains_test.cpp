#include "analysis/gear_trains.h"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/check.h"
#include "analysis/drive_check.h"
#include "parts/catalogue.h"

namespace liftarm::analysis {
namespace {

using lattice::Pose;
using lattice::Vec3;

constexpr const char* kHead = R"({"format": "technic-sketch", "version": 2, "lines": [
  {"from": [0, 0, 0], "to": [8, 0, 0]}, {"from": [0, 2, 0], "to": [8, 2, 0]}],
  "shafts": [{"from": [2, -1, 0], "to": [2, 2, 0]}, {"from": [5, -1, 0], "to": [5, 2, 0]}],
  "drives": [{"from": 0, "to": 1, "ratio": )";

//! Turns a part whose own axis is x along y.
const lattice::Mat3 kAxleAlongY = lattice::fromColumns({0, 1, 0}, {-1, 0, 0}, {0, 0, 1});

//! Two beams along x, two modules apart, and between them axles along y with a gear in the middle.
model::Model twoShafts(const std::string& first, const std::string& second, double apart) {
  model::Model model;
  for (const double y : {0.0, 2.0}) {
    // A beam's holes are along its z, and it lies along its y.
    model.parts.push_back(
        {"40490", 71, {{4, y, 0}, lattice::fromColumns({0, 0, 1}, {1, 0, 0}, {0, 1, 0})}});
  }
  for (const double x : {2.0, 2.0 + apart}) {
    model.parts.push_back({"3705", 0, {{x, 0.5, 0}, kAxleAlongY}});
    model.parts.push_back({"3713", 71, {{x, -1, 0}, {}}});
    model.parts.push_back({x == 2.0 ? first : second, 71, {{x, 1, 0}, {}}});
  }
  return model;
}

GearTrains trainsOf(const model::Model& model) {
  return findGearTrains(makeScene(model, parts::Catalogue::builtIn()));
}

std::vector<Problem> problemsOf(model::Model model, const std::string& ratio) {
  model.sketchJson = kHead + ratio + "}]}";
  const Scene scene = makeScene(model, parts::Catalogue::builtIn());
  EXPECT_EQ(scene.sketchError, "");
  return checkDrives(scene, findGearTrains(scene)).problems;
}

TEST(GearTrains, CoupleTwoShaftsByTheirTeeth) {
  const GearTrains trains = trainsOf(twoShafts("10928", "3649", 3.0));
  ASSERT_EQ(trains.shafts.size(), 2U);
  ASSERT_EQ(trains.meshes.size(), 1U);
  EXPECT_EQ(trains.trains, 1);
  EXPECT_NEAR(trains.shafts[1].speed, -0.2, 1e-12);
  for (const GearShaft& shaft : trains.shafts) {
    EXPECT_TRUE(shaft.turns && shaft.held);
    EXPECT_EQ(shaft.bearings, 2);
    EXPECT_EQ(shaft.parts.size(), 3U);
  }
}

TEST(GearTrains, GearsThatDoNotReachEachOtherAreTrainsOfTheirOwn) {
  const GearTrains trains = trainsOf(twoShafts("10928", "10928", 3.0));
  EXPECT_TRUE(trains.meshes.empty() && trains.clashes.empty());
  EXPECT_EQ(trains.trains, 2);
}

TEST(GearTrains, KnowWhichShaftOfTheSketchTheyAre) {
  model::Model model = twoShafts("10928", "3649", 3.0);
  model.sketchJson = std::string(kHead) + "5}]}";
  const GearTrains trains = trainsOf(model);
  ASSERT_EQ(trains.shafts.size(), 2U);
  EXPECT_EQ(trains.shafts[0].drawn, 0);
  EXPECT_EQ(trains.shafts[1].drawn, 1);
}

TEST(GearTrains, ADrawnShaftWithoutGearsIsATrainOfItsOwn) {
  model::Model model = twoShafts("10928", "3649", 3.0);
  model.sketchJson = std::string(kHead) + "5}]}";
  model.parts[4].part = "3713";  // where its gear was
  const GearTrains trains = trainsOf(model);
  ASSERT_EQ(trains.trains, 2);
  EXPECT_EQ(trains.shafts[0].drawn, 0);
  EXPECT_TRUE(trains.shafts[0].turns);
  EXPECT_NEAR(lattice::length(lattice::cross(trains.shafts[0].axis, {0, 1, 0})), 0.0, 1e-12);
}

TEST(GearTrains, TurnWhereNothingHoldsThem) {
  EXPECT_EQ(whyTrainIsStiff(trainsOf(twoShafts("10928", "3649", 3.0)), 0), "");
  EXPECT_EQ(whyTrainIsStiff(trainsOf(twoShafts("94925", "10928", 1.6)), 0),
            "Does not turn: two gears are too near to pass each other and do not mesh.");
}

TEST(GearTrains, GearsBetweenMeshAndPassingClash) {
  EXPECT_EQ(trainsOf(twoShafts("94925", "10928", 1.6)).clashes.size(), 1U);
}

TEST(GearTrains, TurnAboutTheirAxis) {
  const GearTrains trains = trainsOf(twoShafts("10928", "3649", 3.0));
  const Pose quarter = turned(trains.shafts[0], M_PI / 2);
  const Vec3 onAxis = quarter.apply({2, 7, 0});
  EXPECT_NEAR(lattice::length(onAxis - Vec3{2, 7, 0}), 0.0, 1e-9);
  const Vec3 beside = quarter.apply({3, 0, 0});
  EXPECT_NEAR(lattice::length(beside - Vec3{2, 0, -1}), 0.0, 1e-9);
}

TEST(Drives, HoldWithTheRatioThatIsAskedFor) {
  EXPECT_TRUE(problemsOf(twoShafts("10928", "3649", 3.0), "5").empty());
  const auto problems = problemsOf(twoShafts("10928", "3649", 3.0), "4");
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].message, "drives[0]: its ratio is 5, not 4 within 3 %");
}

TEST(Drives, NeedGearsInMesh) {
  const auto problems = problemsOf(twoShafts("10928", "10928", 3.0), "1");
  ASSERT_FALSE(problems.empty());
  EXPECT_EQ(problems[0].message, "drives[0]: no gears couple its shafts");
}

TEST(Drives, MissAnAxleThatIsGone) {
  model::Model model = twoShafts("10928", "3649", 3.0);
  model.parts.erase(model.parts.begin() + 2);
  const auto problems = problemsOf(model, "5");
  ASSERT_FALSE(problems.empty());
  EXPECT_EQ(problems[0].message, "shafts[0]: no axle lies along it");
}

TEST(Drives, SayOfAShaftThatItSlides) {
  model::Model model = twoShafts("10928", "3649", 3.0);
  model.parts.erase(model.parts.begin() + 3);  // its bush
  const auto problems = problemsOf(model, "5");
  ASSERT_FALSE(problems.empty());
  EXPECT_EQ(problems[0].message, "shafts[0]: its axle can slide out");
}

//! Three gears in a ring turn against each other.
TEST(Drives, NameGearsThatBind) {
  model::Model model = twoShafts("94925", "94925", 2.0);
  const double height = std::sqrt(3.0);
  model.parts.push_back({"3705", 0, {{3, 0.5, height}, kAxleAlongY}});
  model.parts.push_back({"94925", 71, {{3, 1, height}, {}}});
  const GearTrains trains = trainsOf(model);
  EXPECT_EQ(trains.meshes.size(), 3U);
  EXPECT_EQ(trains.binding.size(), 1U);
  EXPECT_EQ(whyTrainIsStiff(trains, 0), "Does not turn: its gears ask one shaft for two speeds.");
}

}  // namespace
}  // namespace liftarm::analysis
