#include "search/earlier_layout.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/helpers/frame_sketches.h"
#include "core/helpers/layouts.h"
#include "search/annealer.h"

namespace liftarm::search {
namespace {

using testing::LayoutBench;

AnnealingOptions quickFrom(EarlierLayout earlier = {}) {
  AnnealingOptions options;
  options.starts = 10;
  options.minIterations = 300;
  options.iterationsPerRun = 40;
  options.earlier = std::move(earlier);
  return options;
}

//! All that is allowed by default.
Allowed allowed(const layout::LayoutProblem& problem) {
  static const AnnealingOptions kDefaults;
  return {kDefaults.lengths, kDefaults.bends, kDefaults.frames, problem.sites};
}

//! A finished search with all that it refers to.
struct Finished {
  Finished(const sketch::Sketch& sketch, AnnealingOptions options, std::uint32_t slice = 1000)
      : bench(sketch), annealer(bench.problem, bench.solver, std::move(options)) {
    while (!annealer.advance(slice)) {
    }
  }

  [[nodiscard]] const guide::GuidingGraph& graph() const { return bench.problem.graph; }

  [[nodiscard]] EarlierLayout layout() const {
    return earlierLayout(graph(), bench.problem.sites, annealer.best().covers);
  }

  LayoutBench bench;
  Annealer annealer;
};

//! A house with a mast far from its roof.
sketch::Sketch houseWithMast() {
  sketch::Sketch sketch = testing::houseSketch();
  sketch.lines.push_back({{0, 0, 0}, {-5, 0, 0}, 5, false, {}});
  return sketch;
}

TEST(EarlierLayout, IsKeptWholeByTheSameSketch) {
  const Finished first(testing::houseSketch(), quickFrom());
  const KeptRuns kept = keepRuns(first.graph(), first.layout(), allowed(first.bench.problem));
  EXPECT_EQ(kept.kept, static_cast<int>(first.graph().runs.size()));
  EXPECT_TRUE(kept.touched.empty());
  const Finished second(testing::houseSketch(), quickFrom(first.layout()));
  EXPECT_TRUE(second.annealer.grown());
  EXPECT_EQ(second.annealer.best().covers, first.annealer.best().covers);
}

TEST(EarlierLayout, LeavesWhatIsFarFromANewLineAsItLies) {
  const Finished first(testing::houseSketch(), quickFrom());
  ASSERT_EQ(first.annealer.best().tallies.violations(), 0);
  const Finished grown(houseWithMast(), quickFrom(first.layout()));
  ASSERT_TRUE(grown.annealer.grown());
  EXPECT_EQ(grown.annealer.best().tallies.violations(), 0);
  EXPECT_LT(grown.annealer.iterations(), first.annealer.iterations());
  const KeptRuns kept = keepRuns(grown.graph(), first.layout(), allowed(grown.bench.problem));
  ASSERT_FALSE(kept.touched.empty());
  int same = 0;
  for (std::size_t r = 0; r < kept.covers.size(); ++r) {
    same += kept.covers[r] == grown.annealer.best().covers[r] ? 1 : 0;
  }
  // What meets the mast, and what meets that, may move.
  EXPECT_GE(same, static_cast<int>(kept.covers.size() - 2 * kept.touched.size()));
}

TEST(EarlierLayout, GrowsTheSameInSlicesOfAnySize) {
  const Finished first(testing::houseSketch(), quickFrom());
  const Finished whole(houseWithMast(), quickFrom(first.layout()), 100000);
  const Finished sliced(houseWithMast(), quickFrom(first.layout()), 7);
  EXPECT_EQ(whole.annealer.best().covers, sliced.annealer.best().covers);
  EXPECT_EQ(whole.annealer.iterations(), sliced.annealer.iterations());
}

TEST(EarlierLayout, IsForgottenWhereItDoesNotEndWhole) {
  const Finished cold(testing::houseSketch(), quickFrom());
  EarlierLayout bad = cold.layout();
  for (EarlierRun& run : bad) {
    for (layout::Beam& beam : run.cover.beams) {
      beam.mate = -1;
      beam.layer = 0;  // all in each other's way
    }
  }
  AnnealingOptions options = quickFrom(bad);
  options.minIterations = 1;
  options.iterationsPerRun = 0;
  AnnealingOptions without = quickFrom();
  without.minIterations = options.minIterations;
  without.iterationsPerRun = options.iterationsPerRun;
  const Finished warm(testing::houseSketch(), options);
  const Finished alone(testing::houseSketch(), without);
  EXPECT_FALSE(warm.annealer.grown());
  EXPECT_EQ(warm.annealer.best().covers, alone.annealer.best().covers);
  EXPECT_GT(warm.annealer.iterations(), alone.annealer.iterations());
}

TEST(EarlierLayout, KeepsNothingThatMakesNoSense) {
  const Finished first(testing::cubeSketch(6), quickFrom());
  const auto keptWith = [&](auto change) {
    EarlierLayout bad = first.layout();
    for (EarlierRun& run : bad) {
      change(&run);
    }
    return keepRuns(first.graph(), bad, allowed(first.bench.problem)).kept;
  };
  EXPECT_EQ(keptWith([](EarlierRun* run) { run->to.x += 1.0; }), 0);
  EXPECT_EQ(keptWith([](EarlierRun* run) { run->cover.beams.clear(); }), 0);
  EXPECT_EQ(keptWith([](EarlierRun* run) { run->cover.beams.front().start = -100; }), 0);
  EXPECT_EQ(keptWith([](EarlierRun* run) { run->cover.beams.front().layer = 9; }), 0);
  EXPECT_EQ(keptWith([](EarlierRun* run) { run->cover.beams.front().holes = 8; }), 0);
  EXPECT_EQ(keptWith([](EarlierRun* run) { run->cover.beams.front().mate = 1000; }), 0);
  EXPECT_EQ(keptWith([](EarlierRun* run) { run->cover.beams.front().mate = 0; }), 0);
}

TEST(EarlierLayout, KeepsAnLBeamOnlyWithBothItsArms) {
  const LayoutBench bench(testing::cornerSketch(5));
  const guide::GuidingGraph& graph = bench.problem.graph;
  ASSERT_EQ(graph.runs.size(), 3U);
  // Along x and y, so that both may have their holes along z.
  std::vector<layout::Bend> bends;
  layout::addBends(graph, layout::bentBeamIndex("32526"), 0, 1, 0, &bends);
  ASSERT_FALSE(bends.empty());
  std::vector<layout::Cover> covers{{lattice::Axis::kZ, {bends.front().arm, {1, 5, 1}}},
                                    {lattice::Axis::kZ, {bends.front().mateArm, {1, 5, 1}}},
                                    {graph.runs[2].axes.front(), {{0, 3, 0}, {1, 5, 1}}}};
  EarlierLayout earlier = earlierLayout(graph, bench.problem.sites, covers);
  EXPECT_EQ(keepRuns(graph, earlier, allowed(bench.problem)).kept, 3);
  EarlierLayout wrong = earlier;
  wrong[0].cover.beams.front().holes -= 1;  // no such bent beam
  EXPECT_EQ(keepRuns(graph, wrong, allowed(bench.problem)).kept, 1);
  earlier[1].cover.beams.back().holes = 8;
  EXPECT_EQ(keepRuns(graph, earlier, allowed(bench.problem)).kept, 1);
}

TEST(EarlierLayout, KeepsAFrameWhereAllItsRunsAreKept) {
  const Finished first(testing::rectangleSketch(4, 6), quickFrom());
  ASSERT_EQ(first.annealer.best().tallies.beams, 1);
  sketch::Sketch more = testing::rectangleSketch(4, 6);
  more.lines.push_back({{0, 0, 0}, {-5, 0, 0}, 5, false, {}});
  const Finished afresh(more, quickFrom());
  // The new line goes on from a side, which is another run then: nothing is left of the frame.
  EXPECT_EQ(keepRuns(afresh.graph(), first.layout(), allowed(afresh.bench.problem)).kept, 0);
  more.lines.back() = {{0, 0, 0}, {0, 0, 5}, 5, false, {}};
  const Finished grown(more, quickFrom(first.layout()));
  EXPECT_TRUE(grown.annealer.grown());
  EXPECT_EQ(grown.annealer.best().tallies.beams, 2);
  EXPECT_EQ(keepRuns(grown.graph(), first.layout(), allowed(grown.bench.problem)).kept, 4);
}

TEST(EarlierLayout, KeepsNoFrameThatLiesNowhere) {
  const Finished first(testing::rectangleSketch(4, 6), quickFrom());
  const auto keptWith = [&](auto change) {
    EarlierLayout bad = first.layout();
    change(&bad[0].cover.beams.front());
    return keepRuns(first.graph(), bad, allowed(first.bench.problem)).kept;
  };
  EXPECT_EQ(keptWith([](layout::Beam*) {}), 4);
  EXPECT_EQ(keptWith([](layout::Beam* bar) { bar->layer += 1; }), 0);
  EXPECT_EQ(keptWith([](layout::Beam* bar) { bar->start -= 1; }), 0);
  EXPECT_EQ(keptWith([](layout::Beam* bar) { bar->form = 0; }), 0);
  EXPECT_EQ(keptWith([](layout::Beam* bar) { bar->form = 99; }), 0);
  EXPECT_EQ(keptWith([](layout::Beam* bar) { bar->tail = 1; }), 0);
  EXPECT_EQ(keptWith([](layout::Beam* bar) { *bar = {0, 5, 0}; }), 1);  // a straight beam
}

}  // namespace
}  // namespace liftarm::search
