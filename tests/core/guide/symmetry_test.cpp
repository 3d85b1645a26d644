#include <algorithm>

#include <gtest/gtest.h>

#include "core/helpers/sketches.h"

namespace liftarm::guide {
namespace {

using lattice::Vec3;

Vec3 apply(const GuideSymmetry& symmetry, Vec3 p) {
  return symmetry.linear * p + symmetry.shift;
}

//! Whether every node of the partners lands on a node of the runs.
bool partnersLandOnRuns(const GuidingGraph& graph, const GuideSymmetry& symmetry) {
  const auto position = [&](int node) { return graph.nodes[static_cast<std::size_t>(node)]; };
  for (const int partner : symmetry.partners) {
    for (const int node : graph.runs[static_cast<std::size_t>(partner)].nodes) {
      const Vec3 image = apply(symmetry, position(node));
      const bool found = std::any_of(symmetry.runs.begin(), symmetry.runs.end(), [&](int run) {
        const std::vector<int>& nodes = graph.runs[static_cast<std::size_t>(run)].nodes;
        return std::any_of(nodes.begin(), nodes.end(), [&](int n) {
          return lattice::length(position(n) - image) < 1e-6;
        });
      });
      if (!found) {
        return false;
      }
    }
  }
  return true;
}

sketch::Symmetry mirrorX(double offset) {
  sketch::Symmetry symmetry;
  symmetry.kind = sketch::Symmetry::Kind::kReflection;
  symmetry.normal = {1, 0, 0};
  symmetry.offset = offset;
  return symmetry;
}

TEST(GuideSymmetry, OfNoneIsNone) {
  EXPECT_TRUE(testing::graphOf(testing::squareSketch(8)).symmetries.empty());
}

TEST(GuideSymmetry, MirrorWithoutLinesTakesAllRuns) {
  sketch::Sketch sketch = testing::houseSketch();
  sketch.symmetries.push_back(mirrorX(4.0));
  const GuidingGraph graph = testing::graphOf(sketch);
  ASSERT_EQ(graph.symmetries.size(), 1U);
  EXPECT_EQ(graph.symmetries.front().runs.size(), graph.runs.size());
}

TEST(GuideSymmetry, MirrorBringsPartnersOntoRuns) {
  sketch::Sketch sketch = testing::houseSketch();
  sketch.symmetries.push_back(mirrorX(4.0));
  const GuidingGraph graph = testing::graphOf(sketch);
  ASSERT_EQ(graph.symmetries.size(), 1U);
  EXPECT_TRUE(partnersLandOnRuns(graph, graph.symmetries.front()));
}

TEST(GuideSymmetry, MirrorOfSomeLinesTakesTheirRuns) {
  sketch::Sketch sketch = testing::squareSketch(8);
  sketch.symmetries.push_back(mirrorX(4.0));
  sketch.symmetries.front().lines = {1, 3};
  const GuidingGraph graph = testing::graphOf(sketch);
  ASSERT_EQ(graph.symmetries.size(), 1U);
  EXPECT_EQ(graph.symmetries.front().runs.size(), 2U);
  EXPECT_TRUE(partnersLandOnRuns(graph, graph.symmetries.front()));
}

TEST(GuideSymmetry, ShiftBringsEachImageOntoItsLine) {
  sketch::Sketch sketch =
      testing::sketchFrom({{{0, 0, 0}, {6, 0, 0}}, {{0, 5, 0}, {6, 5, 0}}, {{0, 0, 0}, {0, 5, 0}}});
  sketch::Symmetry shift;
  shift.kind = sketch::Symmetry::Kind::kTranslation;
  shift.vector = {0, 5, 0};
  shift.pairs = {{0, 1}};
  sketch.symmetries.push_back(shift);
  const GuidingGraph graph = testing::graphOf(sketch);
  ASSERT_EQ(graph.symmetries.size(), 1U);
  EXPECT_NE(graph.symmetries.front().runs, graph.symmetries.front().partners);
  EXPECT_TRUE(partnersLandOnRuns(graph, graph.symmetries.front()));
}

}  // namespace
}  // namespace liftarm::guide
