#include "objective/symmetry_measure.h"

#include <gtest/gtest.h>

#include "core/helpers/sketches.h"

namespace liftarm::objective {
namespace {

using lattice::Axis;
using lattice::Vec3;
using layout::Cover;

//! Two lines along y, at x = 0 and x = 6.
guide::GuidingGraph twoPosts() {
  return testing::graphOf(testing::sketchFrom({{{0, 0, 0}, {0, 4, 0}}, {{6, 0, 0}, {6, 4, 0}}}));
}

SymmetryGroup mirrored() {
  return {reflection({1, 0, 0}, 3.0), {0}, {1}};
}

Cover beamOnLayer(Axis axis, int layer) {
  return {axis, {{0, 5, layer}}};
}

TEST(SymmetryMap, MirrorsInAPlane) {
  const Vec3 image = reflection({1, 0, 0}, 3.0).apply({1, 2, 5});
  EXPECT_EQ(image, (Vec3{5, 2, 5}));
}

TEST(SymmetryMap, MirroredTwiceIsTheSamePoint) {
  const SymmetryMap map = reflection({0.6, 0.8, 0}, 2.5);
  const Vec3 p{1.5, -2.0, 3.0};
  EXPECT_LT(lattice::length(map.apply(map.apply(p)) - p), 1e-12);
}

TEST(SymmetryMap, MirrorLeavesItsPlaneInPlace) {
  const Vec3 p{3, 7, -2};
  EXPECT_EQ(reflection({1, 0, 0}, 3.0).apply(p), p);
}

TEST(SymmetryMap, Shifts) {
  EXPECT_EQ(translation({0, 4, 0}).apply({1, 2, 3}), (Vec3{1, 6, 3}));
}

TEST(SymmetryMeasure, OfMirroredBeamsIsZero) {
  EXPECT_EQ(symmetryDeviation(
                twoPosts(), {beamOnLayer(Axis::kZ, 1), beamOnLayer(Axis::kZ, 1)}, {mirrored()}),
            0.0);
}

TEST(SymmetryMeasure, OfBeamsOneLayerApartIsOneOverTheHoles) {
  EXPECT_DOUBLE_EQ(
      symmetryDeviation(
          twoPosts(), {beamOnLayer(Axis::kZ, 0), beamOnLayer(Axis::kZ, 1)}, {mirrored()}),
      1.0 / 5.0);
}

TEST(SymmetryMeasure, MirrorsLayersAlongTheNormal) {
  // Layer 1 along x at x = 0 is the mirror image of layer -1 at x = 6.
  EXPECT_EQ(symmetryDeviation(
                twoPosts(), {beamOnLayer(Axis::kX, 1), beamOnLayer(Axis::kX, -1)}, {mirrored()}),
            0.0);
}

TEST(SymmetryMeasure, SeesAHoleThatHasNoPartner) {
  const Cover longer{Axis::kZ, {{0, 5, 0}}};
  const Cover shorter{Axis::kZ, {{0, 3, 0}}};
  EXPECT_DOUBLE_EQ(symmetryDeviation(twoPosts(), {longer, shorter}, {mirrored()}), 4.0 / 5.0);
  EXPECT_DOUBLE_EQ(symmetryDeviation(twoPosts(), {shorter, longer}, {mirrored()}), 4.0 / 3.0);
}

TEST(SymmetryMeasure, OfAGroupWithItselfNeedsTheMirrorImageInIt) {
  const guide::GuidingGraph graph = testing::graphOf(testing::lineSketch(6));
  const SymmetryGroup self{reflection({1, 0, 0}, 3.0), {0}, {0}};
  EXPECT_EQ(symmetryDeviation(graph, {{Axis::kZ, {{0, 7, 0}}}}, {self}), 0.0);
  EXPECT_GT(symmetryDeviation(graph, {{Axis::kZ, {{0, 5, 0}, {4, 3, 1}}}}, {self}), 0.0);
}

TEST(SymmetryMeasure, IsTheMeanOverGroups) {
  const std::vector<Cover> covers{beamOnLayer(Axis::kZ, 0), beamOnLayer(Axis::kZ, 1)};
  const SymmetryGroup same{translation({0, 0, 0}), {0}, {0}};
  EXPECT_DOUBLE_EQ(symmetryDeviation(twoPosts(), covers, {mirrored(), same}), 1.0 / 10.0);
}

TEST(SymmetryMeasure, WithoutGroupsOrBeamsIsZero) {
  EXPECT_EQ(symmetryDeviation(twoPosts(), {Cover{}, Cover{}}, {}), 0.0);
  EXPECT_EQ(symmetryDeviation(twoPosts(), {Cover{}, Cover{}}, {mirrored()}), 0.0);
}

}  // namespace
}  // namespace liftarm::objective
