#include "search/paper_layout.h"

#include <gtest/gtest.h>

#include "core/helpers/layouts.h"

namespace liftarm::search {
namespace {

using lattice::Axis;

const std::vector<int> kPaperLengths{2, 3, 5, 7, 9, 11, 13, 15};

//! A paper layout of some sketch, with random beams on every run.
struct PaperBench {
  explicit PaperBench(const sketch::Sketch& sketch, std::uint64_t seed = 1)
      : rng(seed),
        problem(layout::makeLayoutProblem(testing::graphOf(sketch))),
        layout(problem, paperStageOne(problem.graph, &rng), kPaperLengths) {}

  void coverAll() {
    while (true) {
      std::vector<int> runs;
      for (std::size_t r = 0; r < problem.graph.runs.size(); ++r) {
        runs.push_back(static_cast<int>(r));
      }
      const std::vector<PaperPlacement> found = layout.placements(runs, true);
      if (found.empty()) {
        return;
      }
      layout.add(found[below(found.size())], static_cast<int>(rng.below(5)) - 2);
    }
  }

  //! Takes beams off around a random edge, now and then turns its run, and covers all again.
  void disturb() {
    const auto run = static_cast<int>(below(problem.graph.runs.size()));
    const guide::GuideRun& guideRun = problem.graph.runs[static_cast<std::size_t>(run)];
    if (guideRun.axes.size() > 1 && rng.below(4) == 0) {
      layout.turn(run, guideRun.axes[rng.below(2)]);
    } else {
      layout.removeAround(run,
                          static_cast<int>(below(static_cast<std::size_t>(guideRun.edgeCount()))));
    }
    coverAll();
    layout.settle();
  }

  std::size_t below(std::size_t bound) { return rng.below(static_cast<std::uint32_t>(bound)); }

  base::Rng rng;
  layout::LayoutProblem problem;
  PaperLayout layout;
};

void expectSame(const PaperSums& a, const PaperSums& b) {
  EXPECT_EQ(a.beams, b.beams);
  EXPECT_EQ(a.holes, b.holes);
  EXPECT_EQ(a.layerSquares, b.layerSquares);
  EXPECT_EQ(a.gaps, b.gaps);
  EXPECT_EQ(a.ownCollisions, b.ownCollisions);
  EXPECT_EQ(a.ownFailures, b.ownFailures);
  EXPECT_EQ(a.uncovered, b.uncovered);
}

TEST(PaperLayout, RevertBringsBackCoversAndSums) {
  PaperBench bench(testing::cubeSketch(8));
  bench.coverAll();
  bench.layout.settle();
  bench.layout.keep();
  for (int i = 0; i < 300; ++i) {
    const std::vector<layout::Cover> covers = bench.layout.covers();
    const PaperSums sums = bench.layout.sums();
    bench.disturb();
    bench.layout.revert();
    ASSERT_TRUE(bench.layout.covers() == covers) << "move " << i;
    expectSame(bench.layout.sums(), sums);
    bench.disturb();
    bench.layout.keep();
  }
}

TEST(PaperLayout, BendsNoBeamRoundRunsOfOneLine) {
  sketch::Sketch sketch = testing::lineSketch(10);
  sketch.lines.push_back(sketch.lines.front());
  sketch.lines.back().to = {4, 0, 0};
  sketch.lines.back().length = 4;
  sketch.lines.back().holeAxis = Axis::kY;
  const PaperBench bench(sketch);
  ASSERT_EQ(bench.problem.graph.runs.size(), 2U);
  for (const PaperPlacement& placement : bench.layout.placements({0, 1}, true)) {
    EXPECT_LT(placement.mate, 0);
  }
}

TEST(PaperLayout, SumsDoNotDependOnTheWayThere) {
  PaperBench bench(testing::houseSketch(), 3);
  bench.coverAll();
  bench.layout.settle();
  for (int i = 0; i < 100; ++i) {
    bench.disturb();
    bench.layout.keep();
  }
  PaperOrientation orientation;
  for (const layout::Cover& cover : bench.layout.covers()) {
    orientation.runs.push_back(cover.axis);
  }
  for (const guide::Junction& junction : bench.problem.graph.junctions) {
    orientation.junctions.push_back(junctionAxis(bench.problem.graph, orientation.runs, junction));
  }
  PaperLayout fresh(bench.problem, orientation, kPaperLengths);
  for (std::size_t r = 0; r < bench.layout.covers().size(); ++r) {
    for (const layout::Beam& beam : bench.layout.covers()[r].beams) {
      const int run = static_cast<int>(r);
      if (beam.mate < 0) {
        fresh.add({run, beam.start, beam.holes, -1, 0, 0, 0}, beam.layer);
      } else if (run < beam.mate) {
        for (const layout::Beam& arm : bench.layout.cover(beam.mate).beams) {
          if (arm.mate == run) {
            fresh.add({run, beam.start, beam.holes, beam.mate, arm.start, arm.holes, 0},
                      beam.layer);
          }
        }
      }
    }
  }
  fresh.settle();
  expectSame(fresh.sums(), bench.layout.sums());
}

TEST(PaperLayout, CoversEveryEdgeThatCanBe) {
  PaperBench bench(testing::cubeSketch(7), 2);
  bench.coverAll();
  bench.layout.settle();
  EXPECT_EQ(bench.layout.sums().uncovered, 0);
}

TEST(PaperLayout, LeavesEdgesWhereHoleAxesDiffer) {
  PaperBench bench(testing::cornerSketch(6));
  int left = 0;
  for (int run = 0; run < 3; ++run) {
    for (int edge = 0; edge < 6; ++edge) {
      left += bench.layout.coverable(run, edge) ? 0 : 1;
    }
  }
  // No axis is across all three lines: one of them starts one node later.
  EXPECT_EQ(left, 1);
}

TEST(PaperLayout, PlacementsCoverWhatTheySay) {
  PaperBench bench(testing::gridSketch(2));
  const int bare = [&] {
    bench.layout.settle();
    return bench.layout.sums().uncovered;
  }();
  for (const PaperPlacement& placement : bench.layout.placements({0, 1, 2}, true)) {
    bench.layout.keep();
    bench.layout.add(placement, 0);
    bench.layout.settle();
    const int onMate = placement.mate > 2 ? placement.mateHoles - 1 : 0;  // not asked for
    ASSERT_EQ(bare - bench.layout.sums().uncovered, placement.covers + onMate);
    bench.layout.revert();
  }
}

TEST(PaperLayout, TakesOffBeamsThatCoverTheEdgeOrStopAtIt) {
  PaperBench bench(testing::lineSketch(12));
  for (const auto& [start, holes, layer] :
       {std::tuple{0, 5, 0}, std::tuple{4, 3, 1}, std::tuple{5, 7, 0}, std::tuple{7, 5, 1}}) {
    bench.layout.add({0, start, holes, -1, 0, 0, 0}, layer);
  }
  bench.layout.removeAround(0, 4);
  // 0..4 stops at node 4, 4..6 covers, 5..11 stops at node 5; 7..11 is elsewhere.
  ASSERT_EQ(bench.layout.cover(0).beams.size(), 1U);
  EXPECT_EQ(bench.layout.cover(0).beams[0].start, 7);
}

TEST(PaperLayout, TakesOffBothArmsOfAnLBeam) {
  PaperBench bench(testing::squareSketch(8));
  for (const PaperPlacement& placement : bench.layout.placements({0}, true)) {
    if (placement.mate >= 0) {
      bench.layout.add(placement, 0);
      bench.layout.removeAround(placement.run, placement.start);
      EXPECT_TRUE(bench.layout.cover(placement.mate).beams.empty());
      return;
    }
  }
  FAIL() << "no L beam fits a square";
}

TEST(PaperLayout, CountsGapsAtNodesThatAreNoJunction) {
  PaperBench bench(testing::lineSketch(6));
  bench.layout.add({0, 0, 5, -1, 0, 0, 0}, -1);
  bench.layout.add({0, 2, 5, -1, 0, 0, 0}, 1);
  bench.layout.settle();
  EXPECT_EQ(bench.layout.sums().gaps, 3);  // nodes 2, 3 and 4
}

TEST(PaperLayout, CountsBeamsInLineThatNoPinJoins) {
  PaperBench bench(testing::lineSketch(6));
  bench.layout.add({0, 0, 5, -1, 0, 0, 0}, 0);
  bench.layout.add({0, 4, 3, -1, 0, 0, 0}, 2);
  bench.layout.settle();
  EXPECT_EQ(bench.layout.sums().ownFailures, 1);
}

}  // namespace
}  // namespace liftarm::search
