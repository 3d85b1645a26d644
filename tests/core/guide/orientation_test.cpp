#include "guide/orientation.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/helpers/sketches.h"

namespace liftarm::guide {
namespace {

using lattice::Axis;
using testing::graphOf;

Orientation estimate(const GuidingGraph& graph, std::uint64_t seed = 1) {
  base::Rng rng(seed);
  return estimateOrientation(graph, 40, &rng);
}

//! The lowest cost over every choice of axes. \pre few runs.
double bestByBruteForce(const GuidingGraph& graph) {
  std::vector<std::size_t> digits(graph.runs.size(), 0);
  double best = 1e18;
  while (true) {
    Orientation orientation;
    for (std::size_t r = 0; r < digits.size(); ++r) {
      orientation.push_back(graph.runs[r].axes[digits[r]]);
    }
    best = std::min(best, orientationCost(graph, orientation));
    std::size_t r = 0;
    while (r < digits.size() && ++digits[r] == graph.runs[r].axes.size()) {
      digits[r++] = 0;
    }
    if (r == digits.size()) {
      return best;
    }
  }
}

TEST(Orientation, PlanarFrameGetsOneAxisEverywhere) {
  for (const sketch::Sketch& sketch :
       {testing::squareSketch(8), testing::gridSketch(4), testing::triangleSketch(2)}) {
    for (const Axis axis : estimate(graphOf(sketch))) {
      EXPECT_EQ(axis, Axis::kZ);
    }
  }
}

TEST(Orientation, CubeReachesTheLowestCost) {
  // Three axes meet at each corner, so two differ there at least once: 8 changes.
  const GuidingGraph graph = graphOf(testing::cubeSketch(8));
  EXPECT_DOUBLE_EQ(orientationCost(graph, estimate(graph)), bestByBruteForce(graph));
}

TEST(Orientation, HouseReachesTheLowestCost) {
  const GuidingGraph graph = graphOf(testing::houseSketch());
  EXPECT_DOUBLE_EQ(orientationCost(graph, estimate(graph)), bestByBruteForce(graph));
}

TEST(Orientation, UsesOnlyAxesThatTheRunMayHave) {
  const GuidingGraph graph = graphOf(testing::houseSketch());
  const Orientation orientation = estimate(graph);
  ASSERT_EQ(orientation.size(), graph.runs.size());
  for (std::size_t r = 0; r < orientation.size(); ++r) {
    const std::vector<Axis>& axes = graph.runs[r].axes;
    EXPECT_TRUE(std::find(axes.begin(), axes.end(), orientation[r]) != axes.end());
  }
}

TEST(Orientation, IsTheSameForTheSameSeed) {
  const GuidingGraph graph = graphOf(testing::houseSketch());
  EXPECT_EQ(estimate(graph, 7), estimate(graph, 7));
}

TEST(Orientation, OfAnEmptyGraphIsEmpty) {
  EXPECT_TRUE(estimate(GuidingGraph{}).empty());
}

}  // namespace
}  // namespace liftarm::guide
