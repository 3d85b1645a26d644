#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/helpers/ldraw_geometry.h"
#include "core/helpers/shared_data.h"
#include "core/helpers/voxel_solids.h"
#include "parts/catalogue.h"

namespace liftarm::parts {
namespace {

using lattice::Vec3;

// The solids are eroded by 0.6 LDU (0.03), and two parts may share 0.03: what our prisms miss by
// less than this cannot be seen by a test of the solids.
constexpr double kSlack = 0.06;
constexpr double kHeadRadius = 0.3;

bool inside(Vec3 p, const Prism& prism) {
  const Vec3 along = prism.to - prism.from;
  const Vec3 offset = p - prism.from;
  const double square = lattice::dot(along, along);
  const double t = square > 0 ? std::clamp(lattice::dot(offset, along) / square, 0.0, 1.0) : 0.0;
  const Vec3 rest = offset - t * along;
  const double height = lattice::dot(rest, prism.axis);
  return std::abs(height) <= prism.halfThickness + kSlack &&
         lattice::length(rest - height * prism.axis) <= prism.radius + kSlack;
}

std::vector<Prism> wholeShape(const Part& part) {
  std::vector<Prism> shape = part.solid;
  shape.insert(shape.end(), part.collars.begin(), part.collars.end());
  for (const Feature& feature : part.features) {
    if (isMale(feature.kind)) {
      shape.push_back(
          {feature.center, feature.center, feature.axis, kHeadRadius, feature.length / 2});
    }
  }
  return shape;
}

TEST(CatalogueSolids, PrismsCoverTheRealSolidOfEveryPart) {
  LIFTARM_NEED_SHARED_DATA();
  testing::VoxelSolids solids;
  for (const Part& part : Catalogue::builtIn().parts()) {
    const testing::VoxelSolid* solid = solids.find(part.id);
    ASSERT_NE(solid, nullptr) << part.id;
    const std::vector<Prism> shape = wholeShape(part);
    const std::vector<Vec3> points = solid->points();
    ASSERT_GT(points.size(), 500U) << part.id;
    std::size_t missed = 0;
    Vec3 example;
    for (const Vec3 p : points) {
      if (std::none_of(shape.begin(), shape.end(), [&](const Prism& q) { return inside(p, q); })) {
        ++missed;
        example = p;
      }
    }
    EXPECT_EQ(missed, 0U) << part.id << " at " << example.x << " " << example.y << " " << example.z;
  }
}

TEST(CatalogueSolids, RealSolidsLeaveEveryHoleOpen) {
  LIFTARM_NEED_SHARED_DATA();
  testing::VoxelSolids solids;
  for (const Part& part : Catalogue::builtIn().parts()) {
    for (const Feature& feature : part.features) {
      if (isMale(feature.kind)) {
        continue;
      }
      for (double t = -0.5; t <= 0.5; t += 0.125) {
        EXPECT_FALSE(
            solids.find(part.id)->contains(feature.center + (t * feature.length) * feature.axis))
            << part.id;
      }
    }
  }
}

class LdrawFeatures : public ::testing::Test {
 protected:
  // How near LDraw's surfaces come to the axis of a feature, over the inner 90 % of its length.
  double clearance(const std::vector<testing::Triangle>& triangles, const Feature& feature) {
    double best = 1e9;
    for (const testing::Triangle& triangle : triangles) {
      best = std::min(
          best,
          testing::distanceToAxis(triangle, feature.center, feature.axis, 0.45 * feature.length));
    }
    return best;
  }

  testing::LdrawGeometry library_;
};

TEST_F(LdrawFeatures, PinHolesAreBoresOfSixLduAroundOurAxis) {
  LIFTARM_NEED_SHARED_DATA();
  for (const Part& part : Catalogue::builtIn().parts()) {
    const std::vector<testing::Triangle> triangles = library_.part(part.id);
    ASSERT_FALSE(triangles.empty()) << part.id;
    for (const Feature& feature : part.features) {
      if (feature.kind == FeatureKind::kPinHole) {
        EXPECT_NEAR(clearance(triangles, feature), 0.3, 0.02) << part.id;
      }
    }
  }
}

TEST_F(LdrawFeatures, AxleHolesAreOpenCrossesAroundOurAxis) {
  LIFTARM_NEED_SHARED_DATA();
  for (const Part& part : Catalogue::builtIn().parts()) {
    const std::vector<testing::Triangle> triangles = library_.part(part.id);
    for (const Feature& feature : part.features) {
      if (feature.kind == FeatureKind::kAxleHole) {
        const double open = clearance(triangles, feature);
        EXPECT_GT(open, 0.09) << part.id;
        EXPECT_LT(open, 0.2) << part.id;
      }
    }
  }
}

TEST_F(LdrawFeatures, HeadsEndWhereOursDo) {
  LIFTARM_NEED_SHARED_DATA();
  for (const Part& part : Catalogue::builtIn().parts()) {
    const std::vector<testing::Triangle> triangles = library_.part(part.id);
    for (const Feature& feature : part.features) {
      if (!isMale(feature.kind)) {
        continue;
      }
      double furthest = 0.0;
      for (const testing::Triangle& triangle : triangles) {
        for (const Vec3 corner : triangle) {
          const Vec3 offset = corner - feature.center;
          const double along = lattice::dot(offset, feature.axis);
          if (lattice::length(offset - along * feature.axis) < 0.33 &&
              std::abs(along) <= feature.length / 2 + 0.02) {
            furthest = std::max(furthest, std::abs(along));
          }
        }
      }
      EXPECT_NEAR(furthest, feature.length / 2, 0.02) << part.id;
    }
  }
}

TEST_F(LdrawFeatures, BoundsAreThoseOfTheTriangles) {
  LIFTARM_NEED_SHARED_DATA();
  for (const Part& part : Catalogue::builtIn().parts()) {
    Vec3 low{1e9, 1e9, 1e9};
    Vec3 high{-1e9, -1e9, -1e9};
    for (const testing::Triangle& triangle : library_.part(part.id)) {
      for (const Vec3 corner : triangle) {
        for (int i = 0; i < 3; ++i) {
          low[i] = std::min(low[i], corner[i]);
          high[i] = std::max(high[i], corner[i]);
        }
      }
    }
    EXPECT_LT(lattice::length(low - part.boundsMin), 1e-3) << part.id;
    EXPECT_LT(lattice::length(high - part.boundsMax), 1e-3) << part.id;
  }
}

}  // namespace
}  // namespace liftarm::parts
