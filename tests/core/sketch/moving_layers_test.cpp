#include "sketch/moving_layers.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sketch/moving_bodies.h"

namespace liftarm::sketch {
namespace {

using lattice::Vec3;

constexpr int kReach = 2;

//! A crank of 2, a coupler of 6, a rocker of 5 on pivots 6 apart in the XZ plane, the crank
//! upright.
Sketch crankRocker(bool required) {
  const Vec3 crank{0, 0, 2};
  const double along = (36.0 - 25.0 + 40.0) / (2.0 * std::sqrt(40.0));
  const double across = std::sqrt(36.0 - along * along);
  const Vec3 way = lattice::normalized(Vec3{6, 0, -2});
  const Vec3 rocker = crank + along * way + across * Vec3{-way.z, 0, way.x};
  Sketch sketch;
  const auto add = [&](Vec3 from, Vec3 to) {
    Line line;
    line.from = from;
    line.to = to;
    line.length = static_cast<int>(std::lround(lattice::length(to - from)));
    sketch.lines.push_back(line);
  };
  add({0, 0, 0}, {6, 0, 0});
  add({0, 0, 0}, crank);
  add(crank, rocker);
  add({6, 0, 0}, rocker);
  const auto joint = [&](Vec3 at, int a, int b) {
    sketch.joints.push_back({at, {0, 1, 0}, {{a}, {b}}, {}});
  };
  joint({0, 0, 0}, 0, 1);
  joint(crank, 1, 2);
  joint(rocker, 2, 3);
  joint({6, 0, 0}, 0, 3);
  if (required) {
    sketch.joints.front().range = {-180.0, 180.0};
  }
  return sketch;
}

TEST(MovingBodies, JointsSetLinesApart) {
  EXPECT_EQ(bodiesOfLines(crankRocker(true)), (std::vector<int>{0, 1, 2, 3}));
  Sketch rigid = crankRocker(true);
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
  // A triangle of rockers: 4 and 4 on pivots 6 apart with a coupler of 3.
  std::vector<PlanePin> pins{{0, 1, 0, 0}, {1, 2, 1.5, 3.708}, {2, 3, 4.5, 3.708}, {0, 3, 6, 0}};
  PlaneLinkage linkage(pins, 4, 0);
  int reached = 0;
  for (int degrees = 3; degrees <= 180; degrees += 3) {
    if (!linkage.turnTo(-degrees * 3.14159265358979323846 / 180.0)) {
      break;
    }
    reached = degrees;
  }
  EXPECT_GT(reached, 6);
  EXPECT_LT(reached, 120);
}

TEST(MovingLayers, NothingIsAskedWhereNoRangeIsRequired) {
  EXPECT_TRUE(movingLayers(crankRocker(false), kReach).empty());
}

TEST(MovingLayers, CouplerAndFrameOfACrankThatGoesRoundShareNoLayer) {
  const std::vector<LayerBits> layers = movingLayers(crankRocker(true), kReach);
  ASSERT_EQ(layers.size(), 4U);
  EXPECT_EQ(layers[0] & layers[2], 0U);
  // Neighbours on a pin lie on neighbouring layers.
  EXPECT_TRUE(layers[1] == layers[0] << 1U || layers[1] == layers[0] >> 1U);
  EXPECT_TRUE(layers[2] == layers[1] << 1U || layers[2] == layers[1] >> 1U);
}

TEST(MovingLayers, AnExactLineStaysOnItsLine) {
  Sketch sketch = crankRocker(true);
  sketch.lines[2].exact = true;
  const std::vector<LayerBits> layers = movingLayers(sketch, kReach);
  ASSERT_FALSE(layers.empty());
  EXPECT_EQ(layers[2], 1U << static_cast<unsigned>(kReach));
}

TEST(MovingLayers, LinesBesideTheMachineAreFree) {
  Sketch sketch = crankRocker(true);
  Line beside;
  beside.from = {20, 0, 0};
  beside.to = {24, 0, 0};
  beside.length = 4;
  sketch.lines.push_back(beside);
  EXPECT_EQ(movingLayers(sketch, kReach).back(), 31U);
}

}  // namespace
}  // namespace liftarm::sketch
