#include "lattice/vec.h"

#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace liftarm::lattice {
namespace {

TEST(Vec3, CrossIsRightHanded) {
  EXPECT_EQ(cross(unitVector(Axis::kX), unitVector(Axis::kY)), unitVector(Axis::kZ));
  EXPECT_EQ(cross(unitVector(Axis::kY), unitVector(Axis::kZ)), unitVector(Axis::kX));
}

TEST(Vec3, CrossIsPerpendicularToBoth) {
  const Vec3 a{1, 2, 3};
  const Vec3 b{-4, 5, 0.5};
  EXPECT_NEAR(dot(cross(a, b), a), 0.0, 1e-12);
  EXPECT_NEAR(dot(cross(a, b), b), 0.0, 1e-12);
}

TEST(Vec3, NormalizedHasLengthOneAndKeepsItsDirection) {
  const Vec3 v = normalized({3, 0, 4});
  EXPECT_NEAR(length(v), 1.0, 1e-15);
  EXPECT_NEAR(v.x, 0.6, 1e-15);
}

TEST(Axis, IndexAndAxisAreInverse) {
  for (const Axis axis : {Axis::kX, Axis::kY, Axis::kZ}) {
    EXPECT_EQ(axisFromIndex(index(axis)), axis);
    EXPECT_EQ(unitVector(axis)[index(axis)], 1.0);
  }
}

TEST(Cell, OrderIsTotalByXThenYThenZ) {
  const std::vector<Cell> cells{{-1, 5, 5}, {0, -1, 9}, {0, 0, -2}, {0, 0, 1}, {1, -9, -9}};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (std::size_t j = 0; j < cells.size(); ++j) {
      EXPECT_EQ(cells[i] < cells[j], i < j);
    }
  }
}

TEST(LatticeRotations, AreTwentyFourDifferentOnesWithTheIdentityFirst) {
  std::set<std::array<double, 9>> different;
  for (const Mat3& rotation : latticeRotations()) {
    different.insert(rotation.m);
  }
  EXPECT_EQ(different.size(), 24U);
  EXPECT_EQ(latticeRotations().front().m, Mat3{}.m);
}

TEST(LatticeRotations, AreProperRotations) {
  for (const Mat3& rotation : latticeRotations()) {
    EXPECT_EQ(determinant(rotation), 1.0);
    EXPECT_EQ((rotation * transposed(rotation)).m, Mat3{}.m);
  }
}

TEST(LatticeRotations, AreClosedUnderProducts) {
  std::set<std::array<double, 9>> all;
  for (const Mat3& rotation : latticeRotations()) {
    all.insert(rotation.m);
  }
  for (const Mat3& a : latticeRotations()) {
    for (const Mat3& b : latticeRotations()) {
      EXPECT_EQ(all.count((a * b).m), 1U);
    }
  }
}

TEST(Mat3, ProductAppliesTheRightFactorFirst) {
  const Mat3& a = latticeRotations()[5];
  const Mat3& b = latticeRotations()[14];
  const Vec3 v{1, 2, 3};
  EXPECT_EQ((a * b) * v, a * (b * v));
}

TEST(Mat3, ColumnsAreTheImagesOfTheAxes) {
  const Mat3 m = fromColumns({0, 1, 0}, {0, 0, 1}, {1, 0, 0});
  EXPECT_EQ(m * unitVector(Axis::kX), (Vec3{0, 1, 0}));
  EXPECT_EQ(m * unitVector(Axis::kZ), (Vec3{1, 0, 0}));
}

TEST(Pose, RotatesBeforeItMoves) {
  const Pose pose{{10, 0, 0}, fromColumns({0, 1, 0}, {-1, 0, 0}, {0, 0, 1})};
  EXPECT_EQ(pose.apply({1, 0, 0}), (Vec3{10, 1, 0}));
}

}  // namespace
}  // namespace liftarm::lattice
