#include <utility>

#include <gtest/gtest.h>

#include "core/helpers/layouts.h"
#include "layout/layout.h"

namespace liftarm::layout {
namespace {

using testing::LayoutBench;

//! A corner of three beams along x, y and z that all begin so many modules from it.
sketch::Sketch cornerOfThree() {
  return testing::sketchFrom(
      {{{0, 0, 0}, {6, 0, 0}}, {{0, 0, 0}, {0, 6, 0}}, {{0, 0, 0}, {0, 0, 6}}});
}

Tallies talliesOf(const LayoutBench& bench, layout::ConnectionSolver& solver, std::uint64_t seed) {
  base::Rng rng(seed);
  Layout layout(bench.problem, solver);
  for (std::size_t r = 0; r < bench.problem.graph.runs.size(); ++r) {
    // Every other beam leaves an edge bare at either end.
    Cover cover = testing::randomCover(bench.problem.graph.runs[r], &rng);
    if (rng.below(2) == 0) {
      cover.beams = {{1, 5, static_cast<int>(rng.below(3)) - 1}};
    }
    layout.setCover(static_cast<int>(r), std::move(cover));
  }
  layout.settleAll();
  return layout.tallies();
}

// Fewer holes may be used. At a single junction that may even help: it leaves its neighbour more
// room.
TEST(CloseGroups, JoinLessOnTheWhole) {
  LayoutBench wide(testing::cubeSketch(6));
  LayoutBench close(testing::cubeSketch(6));
  close.problem.closeGroups = true;
  int inReach = 0;
  int all = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    inReach += talliesOf(close, close.solver, seed).failedConnections;
    all += talliesOf(wide, wide.solver, seed).failedConnections;
  }
  EXPECT_GT(inReach, all);
}

TEST(CloseGroups, StillJoinAStack) {
  LayoutBench bench(testing::squareSketch(6));
  bench.problem.closeGroups = true;
  Layout layout(bench.problem, bench.solver);
  for (std::size_t r = 0; r < bench.problem.graph.runs.size(); ++r) {
    const guide::GuideRun& run = bench.problem.graph.runs[r];
    const int layer = run.direction.x != 0.0 ? 0 : 1;
    layout.setCover(static_cast<int>(r), {lattice::Axis::kZ, {{0, 7, layer}}});
  }
  layout.settleAll();
  EXPECT_EQ(layout.tallies().violations(), 0);
}

TEST(CloseGroups, ReachPastAnUncoveredEdge) {
  LayoutBench bench(cornerOfThree());
  bench.problem.closeGroups = true;
  Layout layout(bench.problem, bench.solver);
  for (std::size_t r = 0; r < bench.problem.graph.runs.size(); ++r) {
    const guide::GuideRun& run = bench.problem.graph.runs[r];
    const bool forward = run.nodes.front() == bench.problem.graph.junctions[0].node;
    const bool upright = run.direction.z != 0.0;
    const int start = upright && forward ? 1 : 0;
    const int holes = upright ? 6 : 7;
    layout.setCover(static_cast<int>(r),
                    {upright ? lattice::Axis::kX : lattice::Axis::kZ,
                     {{start, holes, run.direction.y != 0.0 ? 1 : 0}}});
  }
  layout.settleAll();
  EXPECT_EQ(layout.tallies().failedConnections, 0);
}

}  // namespace
}  // namespace liftarm::layout
