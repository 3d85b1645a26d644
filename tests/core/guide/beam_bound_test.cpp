#include "guide/beam_bound.h"

#include <gtest/gtest.h>

#include "core/helpers/sketches.h"

namespace liftarm::guide {
namespace {

using testing::graphOf;

int fewestOnLine(int edges) {
  const GuidingGraph graph = graphOf(testing::lineSketch(edges));
  const GuideRun& run = graph.runs.front();
  return fewestBeams(run, std::vector<bool>(run.nodes.size(), false));
}

TEST(BeamBound, OneBeamReachesFourteenEdges) {
  for (int edges = 1; edges <= 14; ++edges) {
    EXPECT_EQ(fewestOnLine(edges), 1) << edges;
  }
  EXPECT_EQ(fewestOnLine(15), 2);
  EXPECT_EQ(fewestOnLine(28), 2);
  EXPECT_EQ(fewestOnLine(29), 3);
}

TEST(BeamBound, BridgedEndSavesABeamOnALineOfFifteen) {
  const GuidingGraph graph = graphOf(testing::lineSketch(15));
  std::vector<bool> bridged(16, false);
  bridged.front() = true;
  EXPECT_EQ(fewestBeams(graph.runs.front(), bridged), 1);
}

TEST(BeamBound, BridgedMiddleSavesABeamOnALineOfThirty) {
  const GuidingGraph graph = graphOf(testing::lineSketch(30));
  std::vector<bool> bridged(31, false);
  bridged[15] = true;
  EXPECT_EQ(fewestBeams(graph.runs.front(), bridged), 2);
}

TEST(BeamBound, NeedsABeamEvenWhereEveryEdgeCouldBeBridged) {
  const GuidingGraph graph = graphOf(testing::lineSketch(2));
  EXPECT_EQ(fewestBeams(graph.runs.front(), {true, true, true}), 1);
}

}  // namespace
}  // namespace liftarm::guide
