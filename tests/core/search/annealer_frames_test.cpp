#include <gtest/gtest.h>

#include "core/helpers/frame_sketches.h"
#include "core/helpers/layouts.h"
#include "search/annealer.h"

namespace liftarm::search {
namespace {

LayoutSnapshot bestOf(const sketch::Sketch& sketch, const AnnealingOptions& options) {
  testing::LayoutBench bench(sketch);
  Annealer annealer(bench.problem, bench.solver, options);
  while (!annealer.advance(1000)) {
  }
  return annealer.best();
}

AnnealingOptions withSeed(std::uint64_t seed) {
  AnnealingOptions options;
  options.seed = seed;
  return options;
}

int framedRuns(const LayoutSnapshot& layout) {
  int runs = 0;
  for (const layout::Cover& cover : layout.covers) {
    runs += std::any_of(cover.beams.begin(),
                        cover.beams.end(),
                        [](const layout::Beam& beam) { return beam.site >= 0; })
                ? 1
                : 0;
  }
  return runs;
}

TEST(AnnealerFrames, EndAsOneFrameWhereOneFits) {
  for (const sketch::Sketch& sketch :
       {testing::rectangleSketch(4, 6), testing::smallHSketch(), testing::ladderSketch()}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const LayoutSnapshot best = bestOf(sketch, withSeed(seed));
      EXPECT_EQ(best.tallies.beams, 1) << "seed " << seed;
      EXPECT_EQ(best.tallies.connectors, 0) << "seed " << seed;
      EXPECT_EQ(best.tallies.violations(), 0) << "seed " << seed;
      EXPECT_EQ(framedRuns(best), static_cast<int>(best.covers.size())) << "seed " << seed;
    }
  }
}

TEST(AnnealerFrames, AreNotLaidWhenSwitchedOff) {
  AnnealingOptions off = withSeed(1);
  off.parts.frames = false;
  EXPECT_EQ(framedRuns(bestOf(testing::rectangleSketch(4, 6), off)), 0);
  AnnealingOptions none = withSeed(1);
  none.frames.clear();
  EXPECT_EQ(framedRuns(bestOf(testing::rectangleSketch(4, 6), none)), 0);
}

TEST(AnnealerFrames, ChangeNothingWhereTheySaveNothing) {
  // Places for 14720 are everywhere in a grid of 4, but it would cost beams there.
  AnnealingOptions off = withSeed(2);
  off.parts.frames = false;
  const LayoutSnapshot with = bestOf(testing::gridSketch(3), withSeed(2));
  EXPECT_EQ(with.covers, bestOf(testing::gridSketch(3), off).covers);
}

TEST(AnnealerFrames, AreWithdrawnWhereNothingCanBeBuiltWithThem) {
  AnnealingOptions strict = withSeed(3);
  strict.parts.axles = false;  // trials of these ask as well
  int asked = 0;
  strict.buildable = [&](const LayoutSnapshot& layout) {
    ++asked;
    return framedRuns(layout) == 0;
  };
  AnnealingOptions off = withSeed(3);
  off.parts.axles = false;
  off.parts.frames = false;
  const LayoutSnapshot best = bestOf(testing::benchSketch(), strict);
  EXPECT_EQ(best.covers, bestOf(testing::benchSketch(), off).covers);
  EXPECT_EQ(best.tallies.violations(), 0);
  EXPECT_LE(asked, 2);
}

TEST(AnnealerFrames, LeaveBentBeamsOnTheirOtherRunsWhole) {
  // Moves that lay and take off frames beside bent beams must leave no arm alone.
  sketch::Sketch sketch = testing::rectangleSketch(4, 6);
  const sketch::Sketch more = testing::sketchFrom({{{4, 6, 0}, {12, 6, 0}},
                                                   {{12, 6, 0}, {12, 2, 0}},
                                                   {{0, 0, 0}, {0, 0, 4}},
                                                   {{4, 0, 0}, {4, -4, 0}}});
  sketch.lines.insert(sketch.lines.end(), more.lines.begin(), more.lines.end());
  testing::LayoutBench bench(sketch);
  Annealer annealer(bench.problem, bench.solver, withSeed(4));
  bool done = false;
  while (!done) {
    done = annealer.advance(7);
    const layout::Layout& now = annealer.current();
    for (int r = 0; r < static_cast<int>(bench.problem.graph.runs.size()); ++r) {
      for (const layout::Beam& arm : layout::armsOf(now.run(r).cover)) {
        int whole = 0;
        int expected = 1;
        for (int other = 0; other < static_cast<int>(bench.problem.graph.runs.size()); ++other) {
          for (const layout::Beam& beam : now.run(other).cover.beams) {
            whole += layout::isOneBeam(r, arm, other, beam) && beam.layer == arm.layer ? 1 : 0;
          }
        }
        if (arm.site >= 0) {
          expected =
              static_cast<int>(bench.problem.sites[static_cast<std::size_t>(arm.site)].arms.size());
        }
        ASSERT_EQ(whole, expected);
      }
    }
  }
}

}  // namespace
}  // namespace liftarm::search
