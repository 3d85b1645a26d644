#include "guide/beam_bound.h"

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/helpers/shared_data.h"
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

TEST(BeamBound, OfACubeIsTwelve) {
  EXPECT_EQ(beamsLowerBound(graphOf(testing::cubeSketch(8))), 12);
}

TEST(BeamBound, CountsPiecesTogether) {
  EXPECT_EQ(beamsLowerBound(
                graphOf(testing::sketchFrom({{{0, 0, 0}, {5, 0, 0}}, {{0, 50, 0}, {20, 50, 0}}}))),
            3);
}

TEST(BeamBound, EqualsTheProvenOptimumOfTheGridPuzzle) {
  LIFTARM_NEED_SHARED_DATA();
  const auto text = testing::readSharedFile("grids.json");
  ASSERT_TRUE(text.has_value());
  const nlohmann::json grids = nlohmann::json::parse(*text, nullptr, false);
  ASSERT_TRUE(grids.is_object());
  for (const nlohmann::json& grid : grids["grids"]) {
    const int n = grid["n"].get<int>();
    EXPECT_EQ(beamsLowerBound(graphOf(testing::gridSketch(n))), grid["straight"].get<int>()) << n;
  }
}

}  // namespace
}  // namespace liftarm::guide
