#include "model/connections.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/helpers/models.h"

namespace liftarm::model {
namespace {

using lattice::Vec3;
using testing::beamAt;
using testing::kX;
using testing::kY;
using testing::kZ;
using testing::partAt;
using testing::pinAt;

std::vector<Connection> connectionsOf(std::vector<PlacedPart> parts) {
  Model model;
  model.parts = std::move(parts);
  return findConnections(model, parts::Catalogue::builtIn());
}

TEST(Connections, APinJoinsTwoBeamsByItsTwoSlots) {
  const auto found = connectionsOf({beamAt("32316", {0, 0, 0}, kX, kZ),
                                    beamAt("32316", {0, 0, 1}, kY, kZ),
                                    pinAt("2780", {0, 0, 0.5}, kZ)});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].fit, Fit::kTurn);
  EXPECT_EQ(found[0].male, 2);
  EXPECT_NE(found[0].female, found[1].female);
  EXPECT_NE(found[0].maleSlot, found[1].maleSlot);
}

TEST(Connections, OneSlotOfAPinPassesTwoThinBeams) {
  const auto found = connectionsOf({beamAt("32063", {0.5, 0, 0.25}, kX, kZ),
                                    beamAt("32063", {0.5, 0, 0.75}, kX, kZ),
                                    pinAt("2780", {0, 0, 0}, kZ)});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].maleSlot, found[1].maleSlot);
  EXPECT_TRUE(isGood(found[0].fit));
  EXPECT_TRUE(isGood(found[1].fit));
}

TEST(Connections, AThinBeamInTheMiddleOfAPinsSlotIsMisplaced) {
  const auto found =
      connectionsOf({beamAt("32063", {0.5, 0, 0.5}, kX, kZ), pinAt("2780", {0, 0, 0}, kZ)});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].fit, Fit::kMisplaced);
}

TEST(Connections, FitsFollowTheKindsOfHeadAndHole) {
  struct Case {
    const char* male;
    const char* female;
    Fit fit;
  };

  // 2780: pins; 3704: axle; 18654: pin hole; 3713: axle hole along y.
  for (const Case& c : {Case{"2780", "18654", Fit::kTurn},
                        Case{"3704", "18654", Fit::kSlide},
                        Case{"3704", "3713", Fit::kRigid},
                        Case{"2780", "3713", Fit::kWrongKind}}) {
    const bool bush = std::string(c.female) == "3713";
    const Vec3 axis = bush ? kY : kZ;
    const auto found =
        connectionsOf({partAt(c.female, {0, 0, 0}), pinAt(c.male, 0.5 * axis, axis)});
    ASSERT_EQ(found.size(), 1U) << c.male << " " << c.female;
    EXPECT_EQ(found[0].fit, c.fit) << c.male << " " << c.female;
  }
}

TEST(Connections, ACrossFitsAfterAQuarterTurnOnly) {
  for (const double degrees : {0.0, 90.0, 180.0, 270.0, 30.0, 45.0, 10.0}) {
    PlacedPart axle = pinAt("3704", {0, 0.5, 0}, kY);
    testing::turn(axle, kY, degrees);
    const auto found = connectionsOf({partAt("3713", {0, 0, 0}), axle});
    ASSERT_EQ(found.size(), 1U);
    const bool quarter = static_cast<int>(degrees) % 90 == 0;
    EXPECT_EQ(found[0].fit, quarter ? Fit::kRigid : Fit::kTwisted) << degrees;
  }
}

TEST(Connections, HeadsThatAreNotCoaxialMeetNothing) {
  EXPECT_TRUE(
      connectionsOf({partAt("18654", {0, 0, 0}), pinAt("2780", {0, 0.2, 0.5}, kZ)}).empty());
  EXPECT_TRUE(connectionsOf({partAt("18654", {0, 0, 0}), pinAt("2780", {0, 0, 0.5}, kX)}).empty());
}

//! Beams on an axle of five with a stop at its high end, from the stop down, and a bush below them.
std::vector<PlacedPart> stackOnAxle(int beams, int bushBelow) {
  std::vector<PlacedPart> parts;
  PlacedPart axle = partAt("15462", {0, 0, 0});
  testing::turn(axle, kY, -90.0);  // its own x axis, where the stop is, to +z
  parts.push_back(axle);
  for (int i = 0; i < beams; ++i) {
    parts.push_back(beamAt("32316", {0, 0, 2.0 - i}, i % 2 == 0 ? kX : kY, kZ));
  }
  PlacedPart bush = partAt("3713", {0, 0, 2.0 - beams - bushBelow});
  testing::turn(bush, kX, 90.0);
  parts.push_back(bush);
  return parts;
}

int countFit(const std::vector<Connection>& found, Fit fit) {
  int count = 0;
  for (const Connection& c : found) {
    count += c.fit == fit ? 1 : 0;
  }
  return count;
}

TEST(Connections, BeamsBetweenAStopAndABushAreHeld) {
  const auto found = connectionsOf(stackOnAxle(4, 0));
  EXPECT_EQ(countFit(found, Fit::kTurn), 4);
  EXPECT_EQ(countFit(found, Fit::kRigid), 1);
}

TEST(Connections, ABeamTurnedByTwoDegreesAboutOnePinIsOffTheNext) {
  std::vector<PlacedPart> parts{beamAt("32316", {2, 0, 0}, kX, kZ),
                                beamAt("32316", {2, 0, 1}, kX, kZ),
                                pinAt("2780", {0, 0, 0.5}, kZ),
                                pinAt("2780", {1, 0, 0.5}, kZ)};
  EXPECT_EQ(countFit(connectionsOf(parts), Fit::kMisplaced), 0);
  constexpr double kTwoDegrees = 0.0349066;
  testing::turn(parts[1], kZ, 2.0);
  parts[1].pose.position = {2 * std::cos(kTwoDegrees), 2 * std::sin(kTwoDegrees), 1};
  EXPECT_EQ(countFit(connectionsOf(parts), Fit::kMisplaced), 1);
}

TEST(Connections, BeamsWithAGapBeforeTheBushSlide) {
  EXPECT_EQ(countFit(connectionsOf(stackOnAxle(3, 1)), Fit::kSlide), 3);
}

TEST(Connections, BeamsOnAnAxleWithoutABushSlide) {
  std::vector<PlacedPart> parts = stackOnAxle(4, 0);
  parts.pop_back();
  EXPECT_EQ(countFit(connectionsOf(parts), Fit::kSlide), 4);
}

TEST(Connections, AreTheSameWhereverTheModelStands) {
  const Model here = testing::squareWithAxle();
  Model there = here;
  for (PlacedPart& part : there.parts) {
    part.pose.position = part.pose.position + Vec3{-107.37, 3.2, 55.51};
  }
  const auto a = findConnections(here, parts::Catalogue::builtIn());
  const auto b = findConnections(there, parts::Catalogue::builtIn());
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].male, b[i].male);
    EXPECT_EQ(a[i].female, b[i].female);
    EXPECT_EQ(a[i].fit, b[i].fit);
  }
}

}  // namespace
}  // namespace liftarm::model
