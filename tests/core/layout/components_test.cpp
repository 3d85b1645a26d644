#include "layout/components.h"

#include <gtest/gtest.h>

#include "core/helpers/layouts.h"

namespace liftarm::layout {
namespace {

using lattice::Axis;
using testing::graphOf;

std::vector<Cover> coversWithAxis(const guide::GuidingGraph& graph, Axis (*choose)(lattice::Vec3)) {
  std::vector<Cover> covers;
  for (const guide::GuideRun& run : graph.runs) {
    covers.push_back({choose(run.direction), {{0, run.edgeCount() + 1, 0}}});
  }
  return covers;
}

TEST(Components, CubeWithPostsAcrossItsFramesHasTwoFramesAndFourPosts) {
  const guide::GuidingGraph graph = graphOf(testing::cubeSketch(8));
  const auto covers =
      coversWithAxis(graph, [](lattice::Vec3 d) { return d.z != 0.0 ? Axis::kX : Axis::kZ; });
  EXPECT_EQ(findComponents(graph, covers).count, 6);
}

TEST(Components, CubeWithTwoUprightFramesHasTwoFramesAndFourRails) {
  const guide::GuidingGraph graph = graphOf(testing::cubeSketch(8));
  const auto covers =
      coversWithAxis(graph, [](lattice::Vec3 d) { return d.x != 0.0 ? Axis::kZ : Axis::kX; });
  EXPECT_EQ(findComponents(graph, covers).count, 6);
}

TEST(Components, PlanarFrameIsOneComponent) {
  const guide::GuidingGraph graph = graphOf(testing::gridSketch(3));
  const auto covers = coversWithAxis(graph, [](lattice::Vec3) { return Axis::kZ; });
  EXPECT_EQ(findComponents(graph, covers).count, 1);
}

TEST(Components, RunsThatDoNotMeetAreApart) {
  const guide::GuidingGraph graph =
      graphOf(testing::sketchFrom({{{0, 0, 0}, {5, 0, 0}}, {{0, 3, 0}, {5, 3, 0}}}));
  const auto covers = coversWithAxis(graph, [](lattice::Vec3) { return Axis::kZ; });
  EXPECT_EQ(findComponents(graph, covers).count, 2);
}

TEST(Components, RangeIsTakenWithinOneComponent) {
  const guide::GuidingGraph graph =
      graphOf(testing::sketchFrom({{{0, 0, 0}, {5, 0, 0}}, {{0, 3, 0}, {5, 3, 0}}}));
  std::vector<Cover> covers = coversWithAxis(graph, [](lattice::Vec3) { return Axis::kZ; });
  covers[0].beams = {{0, 3, 0}, {2, 4, 1}};
  covers[1].beams = {{0, 6, -2}};
  EXPECT_EQ(largestLayerRange(findComponents(graph, covers), covers), 1);
}

TEST(Components, RangeOfNothingIsZero) {
  EXPECT_EQ(largestLayerRange({}, {}), 0);
}

TEST(InlinePins, TakeTheFirstAndTheLastSharedHole) {
  const guide::GuidingGraph graph = graphOf(testing::lineSketch(12));
  const InlinePins pins = inlinePins(graph.runs.front(), {0, 9, 0}, {5, 8, 1});
  EXPECT_EQ(std::vector<int>(pins.begin(), pins.end()), (std::vector<int>{5, 8}));
  EXPECT_TRUE(pins.has(5));
  EXPECT_FALSE(pins.has(6));
  EXPECT_TRUE(pins.has(8));
}

TEST(InlinePins, LeaveJunctionsToTheirGroup) {
  const guide::GuidingGraph graph = graphOf(testing::teeSketch());
  EXPECT_EQ(inlinePins(graph.runs.front(), {0, 5, 0}, {4, 5, 1}).count, 0);
}

TEST(InlinePins, NeedNeighbouringLayers) {
  const guide::GuidingGraph graph = graphOf(testing::lineSketch(12));
  EXPECT_EQ(inlinePins(graph.runs.front(), {0, 9, -1}, {5, 8, 1}).count, 0);
}

TEST(Beam, OfFourOrSixHolesIsTwoParts) {
  for (const int holes : {2, 3, 5, 7, 9, 11, 13, 15}) {
    EXPECT_EQ(partsOfBeam(holes), 1);
  }
  EXPECT_EQ(partsOfBeam(4), 2);
  EXPECT_EQ(partsOfBeam(6), 2);
}

}  // namespace
}  // namespace liftarm::layout
