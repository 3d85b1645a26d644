#include "analysis/balance.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/helpers/models.h"

namespace liftarm::analysis {
namespace {

using lattice::Vec3;
using model::Model;
using testing::beamAt;
using testing::kX;
using testing::kY;
using testing::kZ;
using testing::modelOf;
using testing::pinAt;

Balance balanceOfModel(const Model& model) {
  const Scene scene = makeScene(model, parts::Catalogue::builtIn());
  return checkBalance(scene).value();
}

//! A beam of 9 holes flat on the floor under one end of a beam of 15.
Model overhang(double shift) {
  return modelOf({beamAt("40490", {0, 0, 0}, kX, kZ),
                  beamAt("32278", {shift, 0, 1}, kX, kZ),
                  pinAt("2780", {4, 0, 0.5}, kZ),
                  pinAt("2780", {3, 0, 0.5}, kZ)});
}

TEST(Balance, SquareOnTheFloorHasItsCentreInTheMiddle) {
  const Balance balance = balanceOfModel(testing::squareFrame());
  EXPECT_NEAR(balance.centre.x, 4, 1e-9);
  EXPECT_NEAR(balance.centre.y, 4, 1e-9);
  EXPECT_NEAR(balance.centre.z, 0.5, 1e-9);
  EXPECT_TRUE(balance.stable);
}

TEST(Balance, FloorIsTheLowestFace) {
  EXPECT_NEAR(balanceOfModel(testing::squareFrame()).ground, -0.5, 1e-9);
}

TEST(Balance, MarginIsTheDistanceToTheNearestSide) {
  // Two beams along x at y = 0 and 8, half a module wide less the play, 9 modules long.
  EXPECT_NEAR(balanceOfModel(testing::squareFrame()).margin, 4.45, 0.02);
}

TEST(Balance, TippingAngleIsThatOfMarginOverHeight) {
  const Balance balance = balanceOfModel(testing::squareFrame());
  const double height = balance.centre.z - balance.ground;
  EXPECT_NEAR(balance.tippingAngle, std::atan2(balance.margin, height) * 180 / M_PI, 1e-9);
}

TEST(Balance, FarOverhangFallsToItsSide) {
  const Balance balance = balanceOfModel(overhang(10));
  EXPECT_FALSE(balance.stable);
  EXPECT_LT(balance.margin, 0);
  EXPECT_EQ(balance.tippingAngle, 0);
  EXPECT_NEAR(balance.direction.x, 1, 1e-9);
}

TEST(Balance, SmallOverhangStands) {
  EXPECT_TRUE(balanceOfModel(overhang(3)).stable);
}

TEST(Balance, BeamOnItsRoundEndFalls) {
  const Balance balance = balanceOfModel(modelOf({beamAt("40490", {0, 0, 4}, kZ, kY)}));
  EXPECT_LT(balance.margin, 0.2);
}

TEST(Balance, MovesWithTheModel) {
  Model model = overhang(3);
  const Balance before = balanceOfModel(model);
  for (model::PlacedPart& part : model.parts) {
    part.pose.position = part.pose.position + Vec3{5, -7, 11};
  }
  const Balance after = balanceOfModel(model);
  EXPECT_NEAR(after.margin, before.margin, 1e-9);
  EXPECT_NEAR(after.tippingAngle, before.tippingAngle, 1e-9);
  EXPECT_NEAR(after.centre.z - before.centre.z, 11, 1e-9);
}

TEST(Balance, TurnsWithTheModel) {
  Model model = overhang(10);
  for (model::PlacedPart& part : model.parts) {
    const Vec3 p = part.pose.position;
    part.pose.position = {-p.y, p.x, p.z};
    testing::turn(part, kZ, 90);
  }
  EXPECT_NEAR(balanceOfModel(model).direction.y, 1, 1e-9);
}

TEST(Balance, WorstAssemblyIsTold) {
  Model model = testing::squareFrame();
  for (model::PlacedPart part : overhang(10).parts) {
    part.pose.position = part.pose.position + Vec3{0, 30, 0};
    model.parts.push_back(part);
  }
  EXPECT_FALSE(balanceOfModel(model).stable);
}

TEST(Support, HullOfAGridIsItsCorners) {
  std::vector<GroundPoint> points;
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y < 3; ++y) {
      points.push_back({static_cast<double>(x), static_cast<double>(y)});
    }
  }
  EXPECT_EQ(convexHull(points).size(), 4U);
}

TEST(Support, HullOfALineIsItsEnds) {
  EXPECT_EQ(convexHull({{0, 0}, {1, 1}, {2, 2}, {1, 1}}).size(), 2U);
}

TEST(Support, HullGoesRoundCounterClockwise) {
  const std::vector<GroundPoint> hull = convexHull({{0, 0}, {3, 0}, {3, 2}, {0, 2}, {1, 1}});
  double area = 0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const GroundPoint a = hull[i];
    const GroundPoint b = hull[(i + 1) % hull.size()];
    area += (a.x * b.y - b.x * a.y) / 2;
  }
  EXPECT_NEAR(area, 6, 1e-9);
}

TEST(CentreOfMass, IsNearTheCornerOfAnLBeam) {
  const parts::Part& part = *parts::Catalogue::builtIn().find("32526");
  const Vec3 centre = centreOfMass(part);
  const Vec3 middle = 0.5 * (part.boundsMin + part.boundsMax);
  EXPECT_GT(lattice::length(centre - middle), 0.3);
}

}  // namespace
}  // namespace liftarm::analysis
