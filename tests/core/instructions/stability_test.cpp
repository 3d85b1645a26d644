#include "instructions/stability.h"

#include <vector>

#include <gtest/gtest.h>

#include "core/helpers/models.h"

namespace liftarm::instructions {
namespace {

using lattice::Vec3;
using testing::beamAt;
using testing::kX;
using testing::kY;
using testing::kZ;

analysis::Scene sceneOf(const model::Model& model) {
  return analysis::makeScene(model, parts::Catalogue::builtIn());
}

TEST(Stability, ABeamLiesOnItsFaceAndNotOnItsEnd) {
  model::Model model;
  model.parts = {beamAt("40490", {0, 0, 0}, kX, kZ)};
  const analysis::Scene scene = sceneOf(model);
  EXPECT_TRUE(standsOn(scene, {0}, kZ));
  EXPECT_TRUE(standsOn(scene, {0}, kY));
  EXPECT_FALSE(standsOn(scene, {0}, kX));
}

TEST(Stability, AnOverhangTipsOver) {
  model::Model model;
  // A short beam on the table carries a long one by its end.
  model.parts = {beamAt("32523", {0, 0, 0}, kY, kZ), beamAt("32278", {7, 0, 1}, kX, kZ)};
  const analysis::Scene scene = sceneOf(model);
  EXPECT_FALSE(standsOn(scene, {0, 1}, kZ));
  EXPECT_TRUE(standsOn(scene, {0}, kZ));
}

TEST(Stability, PartsInTheAirDoNotStandTogether) {
  model::Model model;
  model.parts = {beamAt("32523", {0, 0, 0}, kX, kZ), beamAt("32523", {0, 5, 3}, kX, kZ)};
  const analysis::Scene scene = sceneOf(model);
  EXPECT_FALSE(standTogether(scene, {{0}, {1}}, kZ));
  EXPECT_TRUE(standTogether(scene, {{0}}, kZ));
}

TEST(Stability, ASlantedBeamWithALongPinLiesOnItsOwnSide) {
  constexpr Vec3 kSlant{0.6, 0, 0.8};
  model::Model model;
  model.parts = {beamAt("40490", {0, 0, 0}, kSlant, kY), testing::pinAt("6558", 4.0 * kSlant, kY)};
  const analysis::Scene scene = sceneOf(model);
  EXPECT_FALSE(standAnyway(scene, {{0, 1}}));
  EXPECT_TRUE(canBeLaidDown(scene, {0, 1}));
}

TEST(Stability, AFrameStandsOnOneOfItsSides) {
  const model::Model square = testing::squareFrame();
  EXPECT_TRUE(standAnyway(sceneOf(square), {{0, 1, 2, 3, 4, 5, 6, 7}}));
}

}  // namespace
}  // namespace liftarm::instructions
