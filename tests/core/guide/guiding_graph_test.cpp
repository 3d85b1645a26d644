#include "guide/guiding_graph.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "core/helpers/sketches.h"
#include "guide/hole_shift.h"

namespace liftarm::guide {
namespace {

using lattice::Axis;
using lattice::Vec3;
using testing::graphOf;

int nodeAt(const GuidingGraph& graph, Vec3 p) {
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    if (lattice::length(graph.nodes[n] - p) < 1e-6) {
      return static_cast<int>(n);
    }
  }
  return -1;
}

const Junction* junctionAt(const GuidingGraph& graph, Vec3 p) {
  const int node = nodeAt(graph, p);
  for (const Junction& junction : graph.junctions) {
    if (junction.node == node) {
      return &junction;
    }
  }
  return nullptr;
}

TEST(GuidingGraph, OfASquareHasFourRunsAndFourJunctions) {
  const GuidingGraph graph = graphOf(testing::squareSketch(8));
  EXPECT_EQ(graph.runs.size(), 4U);
  EXPECT_EQ(graph.junctions.size(), 4U);
  EXPECT_EQ(graph.edges, 32);
  EXPECT_EQ(graph.nodes.size(), 32U);
}

TEST(HoleShift, IsNoneWhereLengthsClose) {
  EXPECT_EQ(holeShiftOf({{0, 0, 0}, {1, 0, 0}, {2 + 1e-9, 0, 0}}, {0, 1, 2}), 0.0);
}

TEST(HoleShift, SharesWhatIsLeftBetweenBothEnds) {
  EXPECT_NEAR(holeShiftOf({{0, 0, 0}, {1, 0, 0}, {2.04, 0, 0}}, {0, 1, 2}), 0.02, 1e-12);
  EXPECT_NEAR(holeShiftOf({{0, 0, 0}, {1, 0, 0}, {1.96, 0, 0}}, {0, 1, 2}), -0.02, 1e-12);
}

TEST(GuidingGraph, CornerInAPlaneIsNotBridgeable) {
  for (const Junction& junction : graphOf(testing::squareSketch(8)).junctions) {
    EXPECT_FALSE(junction.bridgeable);
  }
}

TEST(GuidingGraph, CornerInSpaceIsBridgeable) {
  const GuidingGraph graph = graphOf(testing::cornerSketch(5));
  ASSERT_EQ(graph.junctions.size(), 1U);
  EXPECT_TRUE(graph.junctions.front().bridgeable);
  EXPECT_EQ(graph.junctions.front().incident.size(), 3U);
}

TEST(GuidingGraph, CubeHasEightBridgeableCorners) {
  const GuidingGraph graph = graphOf(testing::cubeSketch(6));
  EXPECT_EQ(graph.runs.size(), 12U);
  ASSERT_EQ(graph.junctions.size(), 8U);
  for (const Junction& junction : graph.junctions) {
    EXPECT_TRUE(junction.bridgeable);
  }
}

TEST(GuidingGraph, TeeKeepsItsBarInOneRun) {
  const GuidingGraph graph = graphOf(testing::teeSketch());
  ASSERT_EQ(graph.runs.size(), 2U);
  const Junction* junction = junctionAt(graph, {0, 0, 0});
  ASSERT_NE(junction, nullptr);
  std::set<int> indices;
  for (const Incidence& incidence : junction->incident) {
    indices.insert(incidence.index);
  }
  EXPECT_EQ(indices, (std::set<int>{0, 4}));
}

TEST(GuidingGraph, CollinearLinesAreOneRun) {
  const GuidingGraph graph =
      graphOf(testing::sketchFrom({{{0, 0, 0}, {5, 0, 0}}, {{5, 0, 0}, {9, 0, 0}}}));
  ASSERT_EQ(graph.runs.size(), 1U);
  EXPECT_EQ(graph.runs.front().edgeCount(), 9);
  EXPECT_TRUE(graph.junctions.empty());
}

TEST(GuidingGraph, PrincipalRunMayHaveTwoHoleAxes) {
  const GuidingGraph graph = graphOf(testing::lineSketch(4));
  EXPECT_EQ(graph.runs.front().axes, (std::vector<Axis>{Axis::kY, Axis::kZ}));
  EXPECT_TRUE(graph.runs.front().principal);
}

TEST(GuidingGraph, RunThatSnappingLeftOffItsPlaneHasTheAxisItLeansLeastTo) {
  const GuidingGraph graph = graphOf(testing::sketchFrom({{{0, 0, 0}, {0.004, 0.003, 9}}}));
  EXPECT_EQ(graph.runs.front().axes, std::vector<Axis>{Axis::kY});
}

TEST(GuidingGraph, PythagoreanRunHasOnlyTheAxisAcrossItsPlane) {
  const GuidingGraph graph = graphOf(testing::triangleSketch(2));
  int slanted = 0;
  for (const GuideRun& run : graph.runs) {
    if (!run.principal) {
      ++slanted;
      EXPECT_EQ(run.axes, std::vector<Axis>{Axis::kZ});
      EXPECT_EQ(run.edgeCount(), 10);
    }
  }
  EXPECT_EQ(slanted, 1);
}

TEST(GuidingGraph, NodesOfEveryRunAreOneModuleApart) {
  for (const sketch::Sketch& sketch : {testing::triangleSketch(2), testing::houseSketch()}) {
    const GuidingGraph graph = graphOf(sketch);
    for (const GuideRun& run : graph.runs) {
      for (std::size_t i = 1; i < run.nodes.size(); ++i) {
        const Vec3 step = graph.nodes[static_cast<std::size_t>(run.nodes[i])] -
                          graph.nodes[static_cast<std::size_t>(run.nodes[i - 1])];
        EXPECT_LT(lattice::length(step - run.direction), 1e-6);
      }
    }
  }
}

TEST(GuidingGraph, FixedHoleAxisIsTheOnlyOne) {
  sketch::Sketch sketch = testing::lineSketch(6);
  sketch.lines.front().holeAxis = Axis::kY;
  EXPECT_EQ(graphOf(sketch).runs.front().axes, std::vector<Axis>{Axis::kY});
}

TEST(GuidingGraph, ExactPartOfALineIsARunOfItsOwn) {
  sketch::Sketch sketch = testing::sketchFrom({{{0, 0, 0}, {5, 0, 0}}, {{5, 0, 0}, {9, 0, 0}}});
  sketch.lines.back().exact = true;
  const GuidingGraph graph = graphOf(sketch);
  ASSERT_EQ(graph.runs.size(), 2U);
  EXPECT_FALSE(graph.runs[0].exact);
  EXPECT_TRUE(graph.runs[1].exact);
  EXPECT_EQ(graph.junctions.size(), 1U);
}

TEST(GuidingGraph, JointWithAGroupOnEachSideSplitsTheRun) {
  sketch::Sketch sketch = testing::sketchFrom({{{0, 0, 0}, {5, 0, 0}}, {{5, 0, 0}, {10, 0, 0}}});
  sketch.joints.push_back({{5, 0, 0}, {0, 0, 1}, {{0}, {1}}});
  const GuidingGraph graph = graphOf(sketch);
  ASSERT_EQ(graph.runs.size(), 2U);
  ASSERT_EQ(graph.joints.size(), 1U);
  EXPECT_EQ(graph.joints.front().runGroups.size(), 2U);
  EXPECT_EQ(graph.runs[0].axes, std::vector<Axis>{Axis::kZ});
  EXPECT_EQ(graph.runs[1].axes, std::vector<Axis>{Axis::kZ});
}

TEST(GuidingGraph, JointsAboutOneLineAreOneOfAllTheirBodies) {
  sketch::Sketch sketch = testing::cornerSketch(4);
  sketch.joints = {{{0, 0, 0}, {0, 1, 0}, {{0}, {2}}}, {{0, 0, 0}, {0, 1, 0}, {{0}, {1}}}};
  const GuidingGraph graph = graphOf(sketch);
  ASSERT_EQ(graph.joints.size(), 1U);
  EXPECT_EQ(graph.joints[0].runGroups, (std::vector<std::vector<int>>{{0}, {2}, {1}}));
}

TEST(GuidingGraph, JointIsNeverBridgeable) {
  const GuidingGraph graph = graphOf(testing::seesawSketch());
  const Junction* junction = junctionAt(graph, {0, 0, 6});
  ASSERT_NE(junction, nullptr);
  EXPECT_GE(junction->joint, 0);
  EXPECT_FALSE(junction->bridgeable);
}

TEST(GuidingGraph, SeparatePartsAreSeparatePieces) {
  const GuidingGraph graph =
      graphOf(testing::sketchFrom({{{0, 0, 0}, {5, 0, 0}}, {{0, 50, 0}, {5, 50, 0}}}));
  EXPECT_EQ(graph.pieces, 2);
  EXPECT_NE(graph.runs[0].piece, graph.runs[1].piece);
}

TEST(GuidingGraph, NeighboursAreNeighboursOfEachOther) {
  const GuidingGraph graph = graphOf(testing::houseSketch());
  for (std::size_t r = 0; r < graph.runs.size(); ++r) {
    for (const int other : graph.runs[r].near) {
      const std::vector<int>& back = graph.runs[static_cast<std::size_t>(other)].near;
      EXPECT_TRUE(std::find(back.begin(), back.end(), static_cast<int>(r)) != back.end());
    }
  }
}

TEST(GuidingGraph, JunctionIndicesPointAtTheJunctionsNode) {
  const GuidingGraph graph = graphOf(testing::gridSketch(3));
  for (const GuideRun& run : graph.runs) {
    ASSERT_EQ(run.junctions.size(), run.junctionIndices.size());
    EXPECT_TRUE(std::is_sorted(run.junctionIndices.begin(), run.junctionIndices.end()));
    for (std::size_t j = 0; j < run.junctions.size(); ++j) {
      EXPECT_EQ(run.nodes[static_cast<std::size_t>(run.junctionIndices[j])],
                graph.junctions[static_cast<std::size_t>(run.junctions[j])].node);
    }
  }
}

TEST(GuidingGraph, DegreesCountTheUnitEdges) {
  const GuidingGraph graph = graphOf(testing::gridSketch(2));
  int sum = 0;
  for (const int degree : graph.degrees) {
    sum += degree;
  }
  EXPECT_EQ(sum, 2 * graph.edges);
}

}  // namespace
}  // namespace liftarm::guide
