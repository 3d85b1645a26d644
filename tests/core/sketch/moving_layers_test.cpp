#include "sketch/moving_layers.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/helpers/crank_rockers.h"
#include "sketch/moving_bodies.h"

namespace liftarm::sketch {
namespace {

constexpr int kReach = 2;

const std::array<double, 2> kFullTurn{-180.0, 180.0};

TEST(MovingBodies, JointsSetLinesApart) {
  EXPECT_EQ(bodiesOfLines(testing::crankRocker(kFullTurn)), (std::vector<int>{0, 1, 2, 3}));
  Sketch rigid = testing::crankRocker(kFullTurn);
  rigid.joints.pop_back();
  EXPECT_EQ(bodiesOfLines(rigid), (std::vector<int>{0, 1, 2, 0}));
}

TEST(MovingBodies, AClosedChainStaysClosedForAFullTurn) {
  std::vector<PlanePin> pins{{0, 1, 0, 0}, {1, 2, 0, 2}, {2, 3, 5, 4}, {0, 3, 6, 0}};
  PlaneLinkage linkage(pins, 4, 0);
  for (int degrees = 0; degrees <= 180; degrees += 3) {
    ASSERT_TRUE(linkage.turnTo(degrees * 3.14159265358979323846 / 180.0));
    const auto placed = [&](int body, const PlanePin& pin) {
      const PlanePose& pose = linkage.poses()[static_cast<std::size_t>(body)];
      return std::pair{std::cos(pose.angle) * pin.u - std::sin(pose.angle) * pin.v + pose.u,
                       std::sin(pose.angle) * pin.u + std::cos(pose.angle) * pin.v + pose.v};
    };
    for (const PlanePin& pin : pins) {
      EXPECT_NEAR(placed(pin.a, pin).first, placed(pin.b, pin).first, 1e-6);
      EXPECT_NEAR(placed(pin.a, pin).second, placed(pin.b, pin).second, 1e-6);
    }
  }
}

TEST(MovingBodies, AChainStopsAtItsDeadPoint) {
  // Rockers of 4 and 4 on pivots 6 apart with a coupler of 3.
  std::vector<PlanePin> pins{{0, 1, 0, 0}, {1, 2, 1.5, 3.708}, {2, 3, 4.5, 3.708}, {0, 3, 6, 0}};
  PlaneLinkage linkage(pins, 4, 0);
  int reached = 0;
  for (int degrees = 3; degrees <= 180; degrees += 3) {
    if (!linkage.turnTo(degrees * 3.14159265358979323846 / 180.0)) {
      break;
    }
    reached = degrees;
  }
  // Coupler and rocker are in line, 7 long, where the cosine at the crank's pivot is 1/16: 86.4
  // degrees, and the crank begins at 68.0.
  EXPECT_EQ(reached, 18);
}

TEST(MovingLayers, NothingIsAskedWhereNoRangeIsRequired) {
  EXPECT_TRUE(movingLayers(testing::crankRocker(std::nullopt), kReach).empty());
}

TEST(MovingLayers, CouplerAndFrameOfACrankThatGoesRoundShareNoLayer) {
  const std::vector<LayerBits> layers = movingLayers(testing::crankRocker(kFullTurn), kReach);
  ASSERT_EQ(layers.size(), 4U);
  EXPECT_EQ(layers[0] & layers[2], 0U);
  // Neighbours on a pin lie on neighbouring layers.
  EXPECT_TRUE(layers[1] == layers[0] << 1U || layers[1] == layers[0] >> 1U);
  EXPECT_TRUE(layers[2] == layers[1] << 1U || layers[2] == layers[1] >> 1U);
}

TEST(MovingLayers, AnExactLineStaysOnItsLine) {
  Sketch sketch = testing::crankRocker(kFullTurn);
  sketch.lines[2].exact = true;
  const std::vector<LayerBits> layers = movingLayers(sketch, kReach);
  ASSERT_FALSE(layers.empty());
  EXPECT_EQ(layers[2], 1U << static_cast<unsigned>(kReach));
}

TEST(MovingLayers, LinesBesideTheMachineAreFree) {
  Sketch sketch = testing::crankRocker(kFullTurn);
  Line beside;
  beside.from = {20, 0, 0};
  beside.to = {24, 0, 0};
  beside.length = 4;
  sketch.lines.push_back(beside);
  EXPECT_EQ(movingLayers(sketch, kReach).back(), 31U);
}

}  // namespace
}  // namespace liftarm::sketch
