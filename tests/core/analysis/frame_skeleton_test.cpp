#include "analysis/frame_skeleton.h"

#include <gtest/gtest.h>

#include "analysis/materials.h"
#include "analysis/union_find.h"

namespace liftarm::analysis {
namespace {

const parts::Part& part(const char* id) {
  return *parts::Catalogue::builtIn().find(id);
}

double totalLength(const Skeleton& skeleton) {
  double sum = 0.0;
  for (const SkeletonEdge& edge : skeleton.edges) {
    sum += lattice::length(skeleton.points[static_cast<std::size_t>(edge.a)] -
                           skeleton.points[static_cast<std::size_t>(edge.b)]);
  }
  return sum;
}

TEST(Skeleton, OfEveryPartIsConnected) {
  for (const parts::Part& each : parts::Catalogue::builtIn().parts()) {
    const Skeleton skeleton = skeletonOf(each);
    UnionFind pieces(skeleton.points.size());
    for (const SkeletonEdge& edge : skeleton.edges) {
      EXPECT_NE(edge.a, edge.b) << each.id;
      pieces.join(edge.a, edge.b);
    }
    for (std::size_t i = 0; i < skeleton.points.size(); ++i) {
      EXPECT_EQ(pieces.find(static_cast<int>(i)), 0) << each.id;
    }
  }
}

TEST(Skeleton, OfEveryPartHasAPointAtEachSlot) {
  for (const parts::Part& each : parts::Catalogue::builtIn().parts()) {
    const Skeleton skeleton = skeletonOf(each);
    for (std::size_t f = 0; f < each.features.size(); ++f) {
      for (std::size_t s = 0; s < each.features[f].slots.size(); ++s) {
        const auto point = static_cast<std::size_t>(skeleton.pointOfSlot[f][s]);
        EXPECT_LT(lattice::length(skeleton.points[point] - each.features[f].slots[s]), 0.07)
            << each.id;
      }
    }
  }
}

TEST(Skeleton, OfAStraightBeamIsItsRowOfHoles) {
  const Skeleton skeleton = skeletonOf(part("32278"));
  EXPECT_EQ(skeleton.points.size(), 15U);
  EXPECT_EQ(skeleton.edges.size(), 14U);
  EXPECT_DOUBLE_EQ(totalLength(skeleton), 14.0);
}

TEST(Skeleton, OfAFrameIsClosed) {
  const Skeleton skeleton = skeletonOf(part("64179"));
  EXPECT_EQ(skeleton.edges.size(), skeleton.points.size());
  EXPECT_NEAR(totalLength(skeleton), 2 * (6 + 4), 1e-9);
}

TEST(Skeleton, OfAConnectorReachesItsPins) {
  const Skeleton skeleton = skeletonOf(part("55615"));
  int pins = 0;
  for (const SkeletonEdge& edge : skeleton.edges) {
    pins += edge.kind == StretchKind::kPin ? 1 : 0;
  }
  EXPECT_EQ(pins, 4);
}

TEST(Skeleton, OfAnAxlePinIsHalfPinHalfAxle) {
  const Skeleton skeleton = skeletonOf(part("65249"));
  ASSERT_EQ(skeleton.edges.size(), 2U);
  EXPECT_NE(skeleton.edges[0].kind, skeleton.edges[1].kind);
}

TEST(Simplify, LeavesTheEndsAndWhatIsKept) {
  Skeleton skeleton = skeletonOf(part("32278"));
  std::vector<bool> keep(skeleton.points.size(), false);
  keep[4] = true;
  simplify(skeleton, keep);
  EXPECT_EQ(skeleton.edges.size(), 2U);
  EXPECT_DOUBLE_EQ(totalLength(skeleton), 14.0);
}

TEST(Simplify, LeavesCorners) {
  Skeleton skeleton = skeletonOf(part("32140"));
  simplify(skeleton, std::vector<bool>(skeleton.points.size(), false));
  EXPECT_EQ(skeleton.edges.size(), 2U);
  EXPECT_DOUBLE_EQ(totalLength(skeleton), 4.0);
}

}  // namespace
}  // namespace liftarm::analysis
