#include "sketch/point_symmetry.h"

#include <gtest/gtest.h>

#include "core/helpers/sketches.h"

namespace liftarm::sketch {
namespace {

using lattice::Vec3;

void expectImage(const Symmetry& symmetry, Vec3 p, Vec3 image) {
  const Vec3 found = isometryOf(symmetry).apply(p);
  EXPECT_NEAR(lattice::length(found - image), 0.0, 1e-12)
      << found.x << " " << found.y << " " << found.z;
}

Symmetry turn(Vec3 axis, Vec3 point, int order) {
  Symmetry symmetry;
  symmetry.kind = Symmetry::Kind::kRotation;
  symmetry.normal = axis;
  symmetry.vector = point;
  symmetry.order = order;
  return symmetry;
}

TEST(IsometryOf, AMirrorTurnsTheDistanceToItRound) {
  Symmetry mirror;
  mirror.normal = {1, 0, 0};
  mirror.offset = 3;
  expectImage(mirror, {5, 2, 7}, {1, 2, 7});
  mirror.normal = {0.6, 0.8, 0};
  mirror.offset = 5;
  expectImage(mirror, {3, 4, 1}, {3, 4, 1});
  expectImage(mirror, {0, 0, 0}, {6, 8, 0});
}

TEST(IsometryOf, AHalfTurnGoesThroughItsAxis) {
  expectImage(turn({0, 0, 1}, {4, 4, 9}, 2), {1, 2, 5}, {7, 6, 5});
}

TEST(IsometryOf, AQuarterTurnGoesFromXToY) {
  expectImage(turn({0, 0, 1}, {1, 1, 0}, 4), {4, 1, 2}, {1, 4, 2});
}

TEST(IsometryOf, FourQuarterTurnsMoveNothing) {
  const PointIsometry map = isometryOf(turn({0, 1, 0}, {2, 0, 3}, 4));
  const Vec3 p{5, 6, 7};
  EXPECT_NEAR(lattice::length(map.apply(map.apply(map.apply(map.apply(p)))) - p), 0.0, 1e-12);
}

Arrangement arrangementOf(const testing::Segments& lines) {
  return arrange(testing::sketchFrom(lines));
}

TEST(CrossesItself, WhereARunGoesThroughItsImage) {
  Symmetry mirror;
  mirror.normal = {1, 0, 0};
  const PointIsometry map = isometryOf(mirror);
  EXPECT_TRUE(
      crossesItself(arrangementOf({{{-3, -4, 0}, {3, 4, 0}}, {{-3, 4, 0}, {3, -4, 0}}}), map));
  // Drawn in halves that meet in the mirror, it is the same cross.
  EXPECT_TRUE(crossesItself(arrangementOf({{{-3, -4, 0}, {0, 0, 0}},
                                           {{0, 0, 0}, {3, 4, 0}},
                                           {{-3, 4, 0}, {0, 0, 0}},
                                           {{0, 0, 0}, {3, -4, 0}}}),
                            map));
}

TEST(CrossesItself, NotWhereRaftersEndInTheMirror) {
  Symmetry mirror;
  mirror.normal = {1, 0, 0};
  EXPECT_FALSE(crossesItself(arrangementOf({{{-3, 0, 0}, {0, 4, 0}}, {{3, 0, 0}, {0, 4, 0}}}),
                             isometryOf(mirror)));
}

}  // namespace
}  // namespace liftarm::sketch
