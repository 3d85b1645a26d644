#include "analysis/frame_rest.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/helpers/models.h"

namespace liftarm::analysis {
namespace {

using lattice::Vec3;
using testing::kX;
using testing::kY;
using testing::kZ;

Rest restOf(const model::Model& model, Vec3 centre) {
  return findRest(makeScene(model, parts::Catalogue::builtIn()), centre);
}

TEST(Rest, LeavesAFlatFrameAsItIsDrawn) {
  const Rest rest = restOf(testing::squareFrame(), {4, 4, 0.5});
  EXPECT_EQ(rest.tilt, 0.0);
  for (const Foot& foot : rest.feet) {
    EXPECT_LE(foot.part, 1) << "only the lower beams lie on the ground";
  }
}

TEST(Rest, LaysASlantedBeamDown) {
  model::Model model;
  model.parts = {testing::beamAt("32278", {0, 0, 0}, kX, kY)};
  testing::turn(model.parts[0], kY, 30);
  const Rest rest = restOf(model, {0, 0, 0});
  EXPECT_NEAR(rest.tilt, 30.0, 1e-6);
  EXPECT_GE(rest.feet.size(), 4U);
}

TEST(Rest, LetsATallBeamStandOnItsEnd) {
  model::Model model;
  model.parts = {testing::beamAt("32278", {0, 0, 7}, kZ, kY)};
  // Its end is round: it stands on a line, right under its middle.
  EXPECT_EQ(restOf(model, {0, 0, 7}).tilt, 0.0);
}

TEST(Rest, RollsATallBeamOverWhenItsCentreIsBesideItsFoot) {
  model::Model model;
  model.parts = {testing::beamAt("32278", {0, 0, 7}, kZ, kY)};
  EXPECT_NEAR(restOf(model, {0.2, 0, 7}).tilt, 90.0, 1.0);
}

TEST(Rest, StandsOnAPinThatSticksOut) {
  model::Model model = testing::squareFrame();
  // A pin in a corner from below: the frame leans on it.
  model.parts.push_back(testing::pinAt("2780", {0, 8, -0.5}, kZ));
  model.parts[6] = testing::pinAt("3673", {4, 8, 0.5}, kZ);
  const Rest rest = restOf(model, {4, 4, 0.5});
  EXPECT_GT(rest.tilt, 1.0);
  EXPECT_LT(rest.tilt, 10.0);
  bool onPin = false;
  for (const Foot& foot : rest.feet) {
    onPin = onPin || foot.part == 8;
  }
  EXPECT_TRUE(onPin);
}

TEST(Rest, HasTheCentreOfMassOverItsFeet) {
  const Vec3 centre{7, 3, 0.5};
  const Rest rest = restOf(testing::squareFrame(), centre);
  // However the given centre lies, no side of the feet's hull has it outside: some foot is beyond
  // it in every direction.
  const Vec3 e1 = lattice::normalized(lattice::cross(rest.up, kX));
  const Vec3 e2 = lattice::cross(rest.up, e1);
  for (int i = 0; i < 16; ++i) {
    const double angle = i * 0.392699;
    const Vec3 way = std::cos(angle) * e1 + std::sin(angle) * e2;
    double farthest = -1e9;
    for (const Foot& foot : rest.feet) {
      farthest = std::max(farthest, lattice::dot(foot.at - centre, way));
    }
    EXPECT_GE(farthest, -1e-6);
  }
}

}  // namespace
}  // namespace liftarm::analysis
