#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/analysis/well_built_figures.h"
#include "core/helpers/models.h"

namespace liftarm::analysis {
namespace {

using model::Model;
using testing::beamAt;
using testing::figure;
using testing::figureOf;
using testing::itemOf;
using testing::kX;
using testing::kY;
using testing::kZ;
using testing::lights;

TEST(WellBuiltSymmetric, SquareFrameHasItsMirrors) {
  const WellBuiltItem item = itemOf(testing::squareFrame(), "symmetric");
  EXPECT_EQ(figureOf(item, "mirroredBeams"), 4);
  EXPECT_EQ(figureOf(item, "symmetriesKept"), 4);  // beams that meet in a diagonal pass each other
  EXPECT_TRUE(item.ok);
}

TEST(WellBuiltSymmetric, ShiftedBeamHasNoImage) {
  Model model = testing::squareFrame();
  model.parts[3].pose.position.y += 1;
  const WellBuiltItem item = itemOf(model, "symmetric");
  EXPECT_EQ(figureOf(item, "mirroredBeams"), 3);
  EXPECT_TRUE(lights(item, "lopsided", 3));
  EXPECT_FALSE(item.ok);
}

//! Two rafters of five holes whose ends meet at the top, the right one on another layer.
Model raftersOnLayers(double left, double right) {
  Model model;
  model.sketchJson = testing::sketchOf({{{-4, 0, 0}, {0, 0, 3}}, {{4, 0, 0}, {0, 0, 3}}});
  model.parts = {beamAt("32525", {-2, left, 1.5}, {0.8, 0, 0.6}, kY),
                 beamAt("32525", {2, right, 1.5}, {-0.8, 0, 0.6}, kY)};
  return model;
}

TEST(WellBuiltSymmetric, RaftersPassEachOtherOnTheNextLayer) {
  EXPECT_EQ(figure(raftersOnLayers(0, 1), "symmetric", "mirroredBeams"), 2);
  EXPECT_EQ(figure(raftersOnLayers(0, 2), "symmetric", "mirroredBeams"), 0);
}

TEST(WellBuiltSymmetric, BeamOnALineOfEvenHolesHasOneMoreOnOneSide) {
  Model model;
  model.sketchJson =
      testing::sketchOf({{{0, 0, 0}, {5, 0, 0}}, {{0, 0, 0}, {0, 0, 4}}, {{5, 0, 0}, {5, 0, 4}}});
  model.parts = {beamAt("32524", {3, 0, 0}, kX, kY)};  // holes 0 to 6
  EXPECT_EQ(figure(model, "symmetric", "mirroredBeams"), 1);
  model.parts[0].pose.position.x = 4;
  EXPECT_EQ(figure(model, "symmetric", "mirroredBeams"), 0);
}

TEST(WellBuiltSymmetric, MirrorThatTurnsTheHolesOfALineInItAsksForNothing) {
  // Y and Z change places; holes of a beam along X point along one of them.
  Model model;
  model.sketchJson =
      testing::sketchOf({{{0, 0, 0}, {8, 0, 0}}, {{0, 0, 0}, {0, 4, 0}}, {{0, 0, 0}, {0, 0, 4}}});
  model.parts = {beamAt("40490", {4, 0, 0}, kX, kZ)};
  EXPECT_FALSE(itemOf(model, "symmetric").applies);
}

TEST(WellBuiltSymmetric, LopsidedDrawingAsksForNothing) {
  Model model = testing::squareFrame();
  model.sketchJson =
      testing::sketchOf({{{0, 0, 0}, {8, 0, 0}}, {{8, 0, 0}, {8, 5, 0}}, {{8, 0, 0}, {8, 0, 3}}});
  EXPECT_FALSE(itemOf(model, "symmetric").applies);
}

TEST(WellBuiltSymmetric, WithoutAMirrorRotationsCount) {
  // An S: it turns, but its only mirror is its own plane.
  Model model;
  model.sketchJson = testing::sketchOf({{{0, 0, 0}, {4, 0, 0}},
                                        {{4, 0, 0}, {4, 2, 0}},
                                        {{0, 0, 0}, {-4, 0, 0}},
                                        {{-4, 0, 0}, {-4, -2, 0}}});
  model.parts = {beamAt("32316", {2, 0, 0}, kX, kZ), beamAt("32316", {-2, 0, 0}, kX, kZ)};
  EXPECT_EQ(figure(model, "symmetric", "mirroredBeams"), 2);
  model.parts.pop_back();
  EXPECT_EQ(figure(model, "symmetric", "mirroredBeams"), 0);
}

TEST(WellBuiltSymmetric, HalfTurnsCountWhereLinesCrossInEveryMirror) {
  // A cross of two beams, one on the other: no mirror brings it onto itself, half a turn does.
  Model model;
  model.sketchJson = testing::sketchOf({{{-3, -4, 0}, {3, 4, 0}}, {{-3, 4, 0}, {3, -4, 0}}});
  const lattice::Vec3 up = lattice::normalized({3, 4, 0});
  const lattice::Vec3 down = lattice::normalized({3, -4, 0});
  model.parts = {beamAt("40490", {0, 0, 0}, up, kZ), beamAt("40490", {0, 0, 3}, down, kZ)};
  EXPECT_GT(figure(model, "symmetric", "symmetriesKept"), 0);
  model.parts[1].pose.position = {1, 1, 3};
  EXPECT_EQ(figure(model, "symmetric", "symmetriesKept"), 0);
}

}  // namespace
}  // namespace liftarm::analysis
