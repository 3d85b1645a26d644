#include "sketch/arrangement.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace liftarm::sketch {
namespace {

using lattice::Axis;
using lattice::Vec3;

Line line(Vec3 from, Vec3 to) {
  Line result;
  result.from = from;
  result.to = to;
  result.length = static_cast<int>(std::lround(lattice::length(to - from)));
  return result;
}

Sketch sketchOf(std::vector<Line> lines) {
  Sketch sketch;
  sketch.lines = std::move(lines);
  return sketch;
}

std::size_t junctions(const Arrangement& arrangement) {
  std::size_t count = 0;
  for (const ArrangedNode& node : arrangement.nodes) {
    count += node.runs.size() > 1 ? 1U : 0U;
  }
  return count;
}

TEST(Arrange, OneLineIsOneRunWithOneNodeMoreThanEdges) {
  const Arrangement arrangement = arrange(sketchOf({line({0, 0, 0}, {5, 0, 0})}));
  ASSERT_EQ(arrangement.runs.size(), 1U);
  EXPECT_EQ(arrangement.runs[0].direction, (Vec3{1, 0, 0}));
  EXPECT_EQ(arrangement.runs[0].nodes, (std::vector<int>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(arrangement.runs[0].edges.size(), 5U);
  EXPECT_EQ(arrangement.nodes[2].position, (Vec3{2, 0, 0}));
  EXPECT_EQ(arrangement.pieces, 1);
}

TEST(Arrange, ACornerIsTwoRunsWithOneSharedNode) {
  const Arrangement arrangement =
      arrange(sketchOf({line({0, 0, 0}, {5, 0, 0}), line({5, 0, 0}, {5, 0, 5})}));
  EXPECT_EQ(arrangement.runs.size(), 2U);
  EXPECT_EQ(arrangement.nodes[5].runs, (std::vector<std::pair<int, int>>{{0, 5}, {1, 0}}));
  EXPECT_EQ(junctions(arrangement), 1U);
  EXPECT_EQ(arrangement.pieces, 1);
}

TEST(Arrange, ATContactKeepsTheRunThroughIt) {
  const Arrangement arrangement =
      arrange(sketchOf({line({3, 0, 0}, {3, 0, 5}), line({0, 0, 0}, {6, 0, 0})}));
  ASSERT_EQ(arrangement.runs.size(), 2U);
  EXPECT_EQ(arrangement.runs[1].edges.size(), 6U);
  EXPECT_EQ(arrangement.runs[1].nodes[3], arrangement.runs[0].nodes[0]);
}

TEST(Arrange, ACrossingAtNodesOfBothIsAJunction) {
  const Arrangement arrangement =
      arrange(sketchOf({line({-2, 0, 0}, {2, 0, 0}), line({0, -3, 0}, {0, 3, 0})}));
  EXPECT_EQ(arrangement.runs.size(), 2U);
  EXPECT_EQ(junctions(arrangement), 1U);
  EXPECT_TRUE(arrangement.offNodeCrossings.empty());
}

TEST(Arrange, CollinearLinesThatOverlapOrMeetAreOneRun) {
  const Arrangement arrangement = arrange(sketchOf(
      {line({3, 0, 0}, {7, 0, 0}), line({5, 0, 0}, {0, 0, 0}), line({7, 0, 0}, {9, 0, 0})}));
  ASSERT_EQ(arrangement.runs.size(), 1U);
  const sketch::Run& run = arrangement.runs[0];
  EXPECT_EQ(run.direction, (Vec3{1, 0, 0}));
  EXPECT_EQ(run.edges.size(), 9U);
  EXPECT_EQ(arrangement.nodes[static_cast<std::size_t>(run.nodes[0])].position, (Vec3{0, 0, 0}));
  EXPECT_EQ(run.edges[2].lines, (std::vector<int>{1}));
  EXPECT_EQ(run.edges[3].lines, (std::vector<int>{0, 1}));
  EXPECT_EQ(run.edges[8].lines, (std::vector<int>{2}));
}

TEST(Arrange, TheFirstLineOfARunGivesItsDirection) {
  const Arrangement arrangement =
      arrange(sketchOf({line({5, 0, 0}, {3, 0, 0}), line({5, 0, 0}, {9, 0, 0})}));
  ASSERT_EQ(arrangement.runs.size(), 1U);
  EXPECT_EQ(arrangement.runs[0].direction, (Vec3{-1, 0, 0}));
}

TEST(Arrange, CollinearLinesWithAGapAreTwoRunsAndTwoPieces) {
  const Arrangement arrangement =
      arrange(sketchOf({line({0, 0, 0}, {3, 0, 0}), line({4, 0, 0}, {7, 0, 0})}));
  EXPECT_EQ(arrangement.runs.size(), 2U);
  EXPECT_EQ(arrangement.pieces, 2);
  EXPECT_EQ(arrangement.runs[1].piece, 1);
}

TEST(Arrange, ALineDrawnTwiceIsOneRunWithBothSources) {
  const Arrangement arrangement =
      arrange(sketchOf({line({0, 0, 0}, {0, 4, 0}), line({0, 4, 0}, {0, 0, 0})}));
  ASSERT_EQ(arrangement.runs.size(), 1U);
  EXPECT_EQ(arrangement.runs[0].edges[0].lines, (std::vector<int>{0, 1}));
}

TEST(Arrange, ExactAndHoleAxisHoldForTheEdgesOfTheirLineOnly) {
  Line fixed = line({3, 0, 0}, {5, 0, 0});
  fixed.exact = true;
  fixed.holeAxis = Axis::kZ;
  const Arrangement arrangement = arrange(sketchOf({line({0, 0, 0}, {4, 0, 0}), fixed}));
  ASSERT_EQ(arrangement.runs.size(), 1U);
  const std::vector<ArrangedEdge>& edges = arrangement.runs[0].edges;
  EXPECT_FALSE(edges[2].exact);
  EXPECT_FALSE(edges[2].holeAxis.has_value());
  EXPECT_TRUE(edges[3].exact);
  EXPECT_EQ(edges[3].holeAxis, Axis::kZ);
  EXPECT_EQ(edges[4].holeAxis, Axis::kZ);
}

TEST(Arrange, AThreeFourFiveBraceMeetsTheFrameAtItsEnds) {
  const Arrangement arrangement = arrange(sketchOf(
      {line({0, 0, 0}, {4, 0, 0}), line({0, 0, 0}, {0, 0, 3}), line({4, 0, 0}, {0, 0, 3})}));
  EXPECT_EQ(arrangement.runs.size(), 3U);
  EXPECT_EQ(junctions(arrangement), 3U);
  EXPECT_EQ(arrangement.runs[2].direction, (Vec3{-0.8, 0, 0.6}));
  EXPECT_TRUE(arrangement.offNodeCrossings.empty());
}

TEST(Arrange, SixtyDegreeLinesThatGoOnStraightAreOneRun) {
  const double height = 2.0 * std::sqrt(3.0);
  const Arrangement arrangement = arrange(sketchOf({line({0, 0, 0}, {2, 0, height}),
                                                    line({4, 0, 2 * height}, {2, 0, height}),
                                                    line({2, 0, height}, {6, 0, height})}));
  ASSERT_EQ(arrangement.runs.size(), 2U);
  EXPECT_EQ(arrangement.runs[0].edges.size(), 8U);
  EXPECT_EQ(junctions(arrangement), 1U);
}

TEST(Arrange, ListsACrossingBetweenNodesWithItsPoint) {
  const Arrangement arrangement =
      arrange(sketchOf({line({0, 0, 0}, {3, 4, 0}), line({0, 1, 0}, {4, 1, 0})}));
  ASSERT_EQ(arrangement.offNodeCrossings.size(), 1U);
  EXPECT_EQ(arrangement.offNodeCrossings[0].runA, 0);
  EXPECT_EQ(arrangement.offNodeCrossings[0].runB, 1);
  EXPECT_NEAR(arrangement.offNodeCrossings[0].point.x, 0.75, 1e-12);
  EXPECT_EQ(arrangement.pieces, 2);
}

TEST(Arrange, ListsAnEndPointThatTouchesBetweenNodes) {
  const Arrangement arrangement =
      arrange(sketchOf({line({0, 0, 0}, {4, 0, 0}), line({1.5, 0, 0}, {1.5, 3, 0})}));
  ASSERT_EQ(arrangement.offNodeCrossings.size(), 1U);
  EXPECT_EQ(arrangement.offNodeCrossings[0].point, (Vec3{1.5, 0, 0}));
}

TEST(Arrange, ListsAnOverlapOutOfStepOnce) {
  const Arrangement arrangement =
      arrange(sketchOf({line({0, 0, 0}, {4, 0, 0}), line({1.5, 0, 0}, {5.5, 0, 0})}));
  EXPECT_EQ(arrangement.runs.size(), 2U);
  ASSERT_EQ(arrangement.offNodeCrossings.size(), 1U);
}

TEST(Arrange, DoesNotListLinesThatPassEachOther) {
  const Arrangement arrangement =
      arrange(sketchOf({line({0, 0, 0}, {3, 4, 0}), line({0, 1, 1}, {4, 1, 1})}));
  EXPECT_TRUE(arrangement.offNodeCrossings.empty());
}

TEST(Arrange, PlacesAJointAndFillsInItsTwoLines) {
  Sketch sketch = sketchOf({line({0, 0, 0}, {6, 0, 0}), line({3, 0, 0}, {3, 0, 5})});
  sketch.joints.push_back({{3, 0, 0}, {0, 1, 0}, {}});
  const Arrangement arrangement = arrange(sketch);
  ASSERT_EQ(arrangement.joints.size(), 1U);
  EXPECT_EQ(arrangement.joints[0].node, arrangement.runs[1].nodes[0]);
  EXPECT_EQ(arrangement.joints[0].lineGroups, (std::vector<std::vector<int>>{{0}, {1}}));
}

TEST(Arrange, AHingeBetweenCollinearLinesEndsTheRun) {
  Sketch sketch = sketchOf({line({0, 0, 0}, {4, 0, 0}), line({4, 0, 0}, {9, 0, 0})});
  sketch.joints.push_back({{4, 0, 0}, {0, 1, 0}, {{0}, {1}}});
  const Arrangement arrangement = arrange(sketch);
  ASSERT_EQ(arrangement.runs.size(), 2U);
  EXPECT_EQ(arrangement.runs[0].nodes.back(), arrangement.runs[1].nodes.front());
  EXPECT_EQ(arrangement.pieces, 1);
}

TEST(Arrange, AJointLeavesARunAloneThatBelongsToOneSide) {
  Sketch sketch = sketchOf(
      {line({0, 0, 0}, {4, 0, 0}), line({4, 0, 0}, {9, 0, 0}), line({4, 0, 0}, {4, 0, 5})});
  sketch.joints.push_back({{4, 0, 0}, {0, 1, 0}, {{0, 1}, {2}}});
  EXPECT_EQ(arrange(sketch).runs.size(), 2U);
}

}  // namespace
}  // namespace liftarm::sketch
