#include "rivals/rivals.h"

#include <map>

#include <gtest/gtest.h>

#include "core/helpers/layouts.h"
#include "rivals/cover_judge.h"

namespace liftarm::rivals {
namespace {

using testing::LayoutBench;

//! A rival at a small part of its usual effort, with all that it refers to.
struct RivalRun {
  RivalRun(std::string_view name, const sketch::Sketch& sketch, std::uint64_t seed = 1)
      : bench(sketch), search(makeRival(name, bench.problem, bench.solver, quick(seed))) {}

  static RivalOptions quick(std::uint64_t seed) {
    RivalOptions options;
    options.paper.seed = seed;
    options.paper.coolingRate = 0.97;
    options.effort = 0.02;
    return options;
  }

  const search::LayoutSnapshot& finish(std::uint32_t slice = 1000000) {
    while (!search->advance(slice)) {
    }
    return search->best();
  }

  LayoutBench bench;
  std::unique_ptr<search::LayoutSearch> search;
};

class Rivals : public ::testing::TestWithParam<std::string_view> {};

TEST_P(Rivals, GiveTheSameLayoutForTheSameSeed) {
  RivalRun a(GetParam(), testing::houseSketch(), 5);
  RivalRun b(GetParam(), testing::houseSketch(), 5);
  EXPECT_EQ(a.finish().covers, b.finish().covers);
}

TEST_P(Rivals, GiveTheSameLayoutInSlicesOfAnySize) {
  RivalRun whole(GetParam(), testing::gridSketch(2));
  RivalRun sliced(GetParam(), testing::gridSketch(2));
  EXPECT_EQ(whole.finish().covers, sliced.finish(1).covers);
}

// Greedy steps take two L beams first, which in two of three ways leave no room for the rest.
TEST_P(Rivals, FindTheSmallestGridWithoutGapAndConnectedBySomeSeed) {
  int fewest = 100;
  for (std::uint64_t seed = 1; seed <= 20 && fewest > 0; ++seed) {
    RivalRun run(GetParam(), testing::gridSketch(1), seed);
    fewest = std::min(fewest, run.finish().tallies.violations());
  }
  EXPECT_EQ(fewest, 0);
}

TEST_P(Rivals, CoverEveryEdgeOfAPlaneGrid) {
  RivalRun run(GetParam(), testing::gridSketch(3));
  const search::LayoutSnapshot& best = run.finish();
  for (std::size_t r = 0; r < best.covers.size(); ++r) {
    for (int edge = 0; edge < run.bench.problem.graph.runs[r].edgeCount(); ++edge) {
      const auto& beams = best.covers[r].beams;
      EXPECT_TRUE(std::any_of(
          beams.begin(),
          beams.end(),
          [&](const layout::Beam& beam) { return beam.start <= edge && beam.last() > edge; }))
          << "run " << r << " edge " << edge;
    }
  }
}

TEST_P(Rivals, KeepTalliesThatBelongToTheirBestLayout) {
  RivalRun run(GetParam(), testing::houseSketch(), 2);
  const search::LayoutSnapshot& best = run.finish();
  layout::Layout layout(run.bench.problem, run.bench.solver);
  for (std::size_t r = 0; r < best.covers.size(); ++r) {
    layout.setCover(static_cast<int>(r), best.covers[r]);
  }
  EXPECT_EQ(layout.tallies().beams, best.tallies.beams);
  EXPECT_EQ(layout.tallies().holes, best.tallies.holes);
  EXPECT_LE(layout.tallies().collisions, best.tallies.collisions);
  EXPECT_EQ(best.junctions.size(), run.bench.problem.graph.junctions.size());
}

TEST_P(Rivals, TellHowFarTheyAre) {
  RivalRun run(GetParam(), testing::gridSketch(1));
  run.search->advance(1);
  EXPECT_LT(run.search->fraction(), 1.0 + (run.search->done() ? 1.0 : 0.0));
  run.finish();
  EXPECT_EQ(run.search->fraction(), 1.0);
  EXPECT_STREQ(run.search->phase(), "done");
}

INSTANTIATE_TEST_SUITE_P(All, Rivals, ::testing::ValuesIn(rivalNames()), [](const auto& named) {
  std::string name(named.param);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

//! Gaps and other faults first, beams second.
std::pair<int, int> quality(std::string_view name, const sketch::Sketch& sketch) {
  RivalRun run(name, sketch);
  const layout::Tallies& tallies = run.finish().tallies;
  return {tallies.gaps + tallies.collisions, tallies.beams};
}

TEST(RivalsTogether, LeaveRandomBehindWhereTheySearch) {
  const auto random = quality("random", testing::gridSketch(3));
  for (const std::string_view name : {"beam-search", "ant-colony", "population"}) {
    EXPECT_LE(quality(name, testing::gridSketch(3)), random) << name;
  }
}

TEST(RivalsTogether, HaveNoOtherNames) {
  LayoutBench bench(testing::squareSketch(4));
  EXPECT_EQ(makeRival("paper", bench.problem, bench.solver, {}), nullptr);
}

TEST(ProblemSize, IsThatOfTheGrid) {
  for (int n = 1; n <= 4; ++n) {
    EXPECT_EQ(problemSize(LayoutBench(testing::gridSketch(n)).problem), n);
  }
}

TEST(CoverJudge, CountsAsAnEmptyLayoutAgainAfterReverting) {
  LayoutBench bench(testing::gridSketch(2));
  base::Rng rng(1);
  search::PaperLayout beams(
      bench.problem, search::paperStageOne(bench.problem.graph, &rng), {5, 9});
  CoverJudge judge(bench.problem, bench.solver);
  const Judgement empty = judge.look(&beams);
  for (const search::PaperPlacement& p : beams.placements({0, 1, 2}, true)) {
    beams.add(p, 0);
  }
  EXPECT_GT(judge.look(&beams).faults, empty.faults);
  judge.revert(&beams);
  EXPECT_EQ(judge.look(&beams).cost(), empty.cost());
}

}  // namespace
}  // namespace liftarm::rivals
