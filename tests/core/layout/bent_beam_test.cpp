#include "layout/bent_beam.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/helpers/layouts.h"

namespace liftarm::layout {
namespace {

using lattice::Vec3;
using parts::FeatureKind;

bool holeAt(const parts::Part& part, const lattice::Pose& pose, Vec3 at, FeatureKind kind) {
  return std::any_of(
      part.features.begin(), part.features.end(), [&](const parts::Feature& feature) {
        return feature.kind == kind && lattice::length(pose.apply(feature.center) - at) < 0.01;
      });
}

TEST(BentBeams, AreTheLTheTAndThoseBentBy53Degrees) {
  std::vector<std::string> parts;
  for (const BentBeam& bent : bentBeams()) {
    parts.push_back(bent.part);
    EXPECT_NEAR(bent.cosine, bent.arms[0].tail && bent.arms[1].tail ? -0.6 : 0.0, 1e-4);
  }
  EXPECT_EQ(parts, (std::vector<std::string>{"32140", "32271", "32348", "32526", "60484", "6629"}));
}

TEST(BentBeams, HaveARoundHoleAtEachNodeOfTheirArmsAndAnAxleHoleAtEachTail) {
  // A wall and a rafter meet at 126.87 degrees, a wall and a floor at 90.
  const guide::GuidingGraph graph = guide::buildGuidingGraph(testing::houseSketch());
  std::vector<int> seen(bentBeams().size(), 0);
  for (int run = 0; run < static_cast<int>(graph.runs.size()); ++run) {
    for (int mate = 0; mate < static_cast<int>(graph.runs.size()); ++mate) {
      const guide::GuideRun& mine = graph.runs[static_cast<std::size_t>(run)];
      const guide::GuideRun& theirs = graph.runs[static_cast<std::size_t>(mate)];
      if (run == mate || commonJunction(graph, run, mate) < 0) {
        continue;
      }
      for (const int form : allBentBeams()) {
        std::vector<Bend> bends;
        addBends(graph, form, run, mate, 0, &bends);
        seen[static_cast<std::size_t>(form)] += static_cast<int>(bends.size());
        for (const auto& [arm, mateArm, first, second] : bends) {
          EXPECT_TRUE(bendsAlong(bentBeams()[static_cast<std::size_t>(form)], first, second));
          EXPECT_GE(arm.solidStart(), -1);
          EXPECT_LE(arm.solidLast(), mine.edgeCount() + 1);
          EXPECT_EQ(arm.mate, mate);
          EXPECT_EQ(mateArm.mate, run);
          const int corner = cornerIndex(graph, run, mate);
          EXPECT_LE(arm.start, corner);
          EXPECT_GE(arm.last(), corner);
          EXPECT_LE(mateArm.start, cornerIndex(graph, mate, run));
          EXPECT_GE(mateArm.last(), cornerIndex(graph, mate, run));
          EXPECT_LE(std::abs(lattice::dot(mine.direction, theirs.direction)), 0.6001);
        }
      }
    }
  }
  for (std::size_t form = 0; form < seen.size(); ++form) {
    EXPECT_GT(seen[form], 0) << bentBeams()[form].part;
  }
}

TEST(BentBeams, PoseLaysBothArmsAlongTheirDirections) {
  const Vec3 corner{2, 3, 4};
  const Vec3 first{0, 0, 1};
  for (const BentBeam& bent : bentBeams()) {
    const parts::Part* part = parts::Catalogue::builtIn().find(bent.part);
    ASSERT_NE(part, nullptr);
    const Vec3 second = bent.cosine < -0.1 ? Vec3{0.8, 0, -0.6} : Vec3{-1, 0, 0};
    ASSERT_TRUE(bendsAlong(bent, first, second));
    const lattice::Pose pose = poseOf(bent, corner, first, second);
    const std::array<Vec3, 2> ways{first, second};
    std::size_t holes = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      const BentArm& arm = bent.arms[i];
      for (int k = -arm.behind; k < arm.holes - arm.behind; ++k) {
        EXPECT_TRUE(
            holeAt(*part, pose, corner + static_cast<double>(k) * ways[i], FeatureKind::kPinHole))
            << bent.part << " arm " << i << " hole " << k;
      }
      const int end = arm.holes - arm.behind;
      EXPECT_EQ(
          arm.tail,
          holeAt(*part, pose, corner + static_cast<double>(end) * ways[i], FeatureKind::kAxleHole))
          << bent.part << " arm " << i;
      holes += static_cast<std::size_t>(arm.holes) + (arm.tail ? 1U : 0U);
    }
    EXPECT_EQ(holes, part->features.size() + 1) << bent.part;
  }
}

TEST(BentBeams, OfNoRightAngleAndNo3To4To5FitNowhere) {
  const BentBeam& bent = bentBeams().front();
  EXPECT_FALSE(bendsAlong(bent, {1, 0, 0}, {0.6, 0.8, 0}));
  EXPECT_FALSE(bendsAlong(bent, {1, 0, 0}, {-1, 0, 0}));
}

}  // namespace
}  // namespace liftarm::layout
