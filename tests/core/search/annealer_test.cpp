#include "search/annealer.h"

#include <algorithm>
#include <memory>

#include <gtest/gtest.h>

#include "core/helpers/layouts.h"

namespace liftarm::search {
namespace {

using testing::LayoutBench;

AnnealingOptions quick(std::uint64_t seed = 1) {
  AnnealingOptions options;
  options.seed = seed;
  options.starts = 10;
  options.minIterations = 200;
  options.iterationsPerRun = 30;
  return options;
}

//! A search with all that it refers to.
struct SearchRun {
  SearchRun(const sketch::Sketch& sketch, AnnealingOptions options)
      : bench(sketch), annealer(bench.problem, bench.solver, std::move(options)) {}

  void finish(std::uint32_t slice) {
    while (!annealer.advance(slice)) {
    }
  }

  LayoutBench bench;
  Annealer annealer;
};

void expectSameBest(const LayoutSnapshot& a, const LayoutSnapshot& b) {
  EXPECT_EQ(a.energy, b.energy);
  ASSERT_EQ(a.covers.size(), b.covers.size());
  for (std::size_t r = 0; r < a.covers.size(); ++r) {
    EXPECT_TRUE(a.covers[r] == b.covers[r]) << "run " << r;
  }
  ASSERT_EQ(a.junctions.size(), b.junctions.size());
  for (std::size_t j = 0; j < a.junctions.size(); ++j) {
    const auto& placedA = a.junctions[j].connection.mechanisms;
    const auto& placedB = b.junctions[j].connection.mechanisms;
    ASSERT_EQ(placedA.size(), placedB.size()) << "junction " << j;
    for (std::size_t m = 0; m < placedA.size(); ++m) {
      EXPECT_EQ(placedA[m].oriented, placedB[m].oriented);
      EXPECT_EQ(placedA[m].at, placedB[m].at);
    }
  }
}

TEST(Annealer, GivesTheSameResultForTheSameSeed) {
  SearchRun a(testing::houseSketch(), quick(5));
  SearchRun b(testing::houseSketch(), quick(5));
  a.finish(1000);
  b.finish(1000);
  expectSameBest(a.annealer.best(), b.annealer.best());
}

TEST(Annealer, GivesTheSameResultInSlicesOfAnySize) {
  SearchRun whole(testing::cubeSketch(6), quick());
  SearchRun sliced(testing::cubeSketch(6), quick());
  whole.finish(1000000);
  sliced.finish(7);
  EXPECT_EQ(whole.annealer.iterations(), sliced.annealer.iterations());
  expectSameBest(whole.annealer.best(), sliced.annealer.best());
}

int beamsOffLine(const LayoutSnapshot& snapshot);

TEST(Annealer, StiffensAlikeInSlicesOfAnySize) {
  AnnealingOptions options = quick();
  options.freedoms = [](const LayoutSnapshot& snapshot) { return 1 + beamsOffLine(snapshot); };
  SearchRun whole(testing::squareSketch(8), options);
  SearchRun sliced(testing::squareSketch(8), options);
  whole.finish(1000000);
  sliced.finish(7);
  EXPECT_EQ(whole.annealer.iterations(), sliced.annealer.iterations());
  expectSameBest(whole.annealer.best(), sliced.annealer.best());
}

TEST(Annealer, NeverMakesItsBestWorse) {
  SearchRun run(testing::houseSketch(), quick(3));
  run.annealer.advance(1);
  int violations = run.annealer.best().tallies.violations();
  double energy = run.annealer.best().energy;
  while (!run.annealer.advance(10)) {
    const LayoutSnapshot& best = run.annealer.best();
    ASSERT_LE(best.tallies.violations(), violations);
    if (best.tallies.violations() == violations) {
      ASSERT_LE(best.energy, energy + 1e-9);
    }
    violations = best.tallies.violations();
    energy = best.energy;
  }
}

TEST(Annealer, KeepsTalliesThatBelongToItsBestLayout) {
  SearchRun run(testing::houseSketch(), quick(4));
  run.finish(1000);
  const LayoutSnapshot& best = run.annealer.best();
  layout::Layout layout(run.bench.problem, run.bench.solver);
  for (std::size_t r = 0; r < best.covers.size(); ++r) {
    layout.setCover(static_cast<int>(r), best.covers[r]);
  }
  EXPECT_EQ(layout.tallies().beams, best.tallies.beams);
  EXPECT_EQ(layout.tallies().holes, best.tallies.holes);
  EXPECT_EQ(layout.tallies().collisions, best.tallies.collisions);
  EXPECT_EQ(layout.tallies().hinges, best.tallies.hinges);
}

TEST(Annealer, CountsOnlyTheProgressItMakes) {
  SearchRun run(testing::squareSketch(8), quick());
  EXPECT_STREQ(run.annealer.phase(), "stageOne");
  run.annealer.advance(5);
  EXPECT_EQ(run.annealer.iterations(), 5U);
  EXPECT_STREQ(run.annealer.phase(), "stageTwo");
  run.finish(100);
  EXPECT_STREQ(run.annealer.phase(), "done");
  EXPECT_EQ(run.annealer.fraction(), 1.0);
}

//! Counts beams of layers other than 0 as freedoms: cheap, and the search can bring it down.
int beamsOffLine(const LayoutSnapshot& snapshot) {
  int count = 0;
  for (const layout::Cover& cover : snapshot.covers) {
    for (const layout::Beam& beam : cover.beams) {
      count += beam.layer == 0 ? 0 : 1;
    }
  }
  return count;
}

TEST(Annealer, GoesOnUntilNothingIsLoose) {
  AnnealingOptions options = quick();
  options.freedoms = [](const LayoutSnapshot& snapshot) {
    return std::max(0, beamsOffLine(snapshot) - 2);
  };
  SearchRun run(testing::cubeSketch(8), options);
  run.finish(1000);
  EXPECT_EQ(run.annealer.best().tallies.violations(), 0);
  EXPECT_EQ(run.annealer.best().freedoms, 0);
  EXPECT_LE(beamsOffLine(run.annealer.best()), 2);
}

//! Connecting parts that are missing to some number: only dearer connections bring it down.
int partsShortOf(const LayoutSnapshot& snapshot, int wanted) {
  return std::max(0, wanted - snapshot.tallies.connectors);
}

TEST(Annealer, JoinsBeamsAnotherWayUntilNothingIsLoose) {
  AnnealingOptions beamsOnly = quick();
  beamsOnly.parts.axles = false;
  SearchRun plain(testing::squareSketch(8), beamsOnly);
  plain.finish(1000);
  const int wanted = plain.annealer.best().tallies.connectors + 3;
  AnnealingOptions options = beamsOnly;
  options.freedoms = [&](const LayoutSnapshot& snapshot) { return partsShortOf(snapshot, wanted); };
  SearchRun run(testing::squareSketch(8), options);
  run.finish(1000);
  EXPECT_EQ(run.annealer.best().tallies.violations(), 0);
  EXPECT_EQ(run.annealer.best().freedoms, 0);
  EXPECT_EQ(run.annealer.best().tallies.beams, plain.annealer.best().tallies.beams);
}

TEST(Annealer, KeepsWhatIsLeastLooseWhenItStartsAgain) {
  AnnealingOptions options = quick();
  int least = 100;
  options.freedoms = [&](const LayoutSnapshot& snapshot) {
    const int count = 1 + beamsOffLine(snapshot);
    least = std::min(least, count);
    return count;
  };
  SearchRun run(testing::cubeSketch(8), options);
  run.finish(1000);
  const LayoutSnapshot& best = run.annealer.best();
  EXPECT_EQ(best.tallies.violations(), 0);
  EXPECT_EQ(best.freedoms, 1 + beamsOffLine(best));
  EXPECT_LE(best.freedoms, least + 1);
  EXPECT_EQ(best.freedoms, options.freedoms(best));
}

TEST(Annealer, KeepsNothingStiffThatCannotBeBuilt) {
  AnnealingOptions options = quick();
  options.freedoms = [](const LayoutSnapshot& snapshot) { return beamsOffLine(snapshot); };
  options.buildable = [](const LayoutSnapshot& snapshot) { return beamsOffLine(snapshot) >= 3; };
  SearchRun run(testing::cubeSketch(8), options);
  run.finish(1000);
  EXPECT_EQ(beamsOffLine(run.annealer.best()), 3);
}

TEST(Annealer, StopsAtOnceWhereNothingIsLoose) {
  SearchRun plain(testing::cubeSketch(8), quick());
  plain.finish(1000);
  AnnealingOptions options = quick();
  options.freedoms = [](const LayoutSnapshot&) { return 0; };
  SearchRun stiff(testing::cubeSketch(8), options);
  stiff.finish(1000);
  EXPECT_EQ(stiff.annealer.iterations(), plain.annealer.iterations());
}

TEST(Annealer, EndsWhereWhatIsLooseStaysSo) {
  AnnealingOptions options = quick();
  options.freedoms = [](const LayoutSnapshot&) { return 1; };
  SearchRun run(testing::cubeSketch(8), options);
  run.finish(1000);
  EXPECT_TRUE(run.annealer.done());
  EXPECT_EQ(run.annealer.best().freedoms, 1);
}

TEST(Annealer, DoesNothingOnceItIsDone) {
  SearchRun run(testing::squareSketch(8), quick());
  run.finish(1000);
  const std::uint64_t iterations = run.annealer.iterations();
  EXPECT_TRUE(run.annealer.advance(100));
  EXPECT_EQ(run.annealer.iterations(), iterations);
}

TEST(Annealer, EndsWhereNoLayoutIsPossible) {
  // A keep-out box in the middle of the line: no cover is without violation.
  sketch::Sketch sketch = testing::lineSketch(8);
  sketch.keepOut.push_back({{3, -9, -9}, {5, 9, 9}});
  AnnealingOptions options = quick();
  options.maxRounds = 2;
  SearchRun run(sketch, options);
  run.finish(1000);
  EXPECT_GT(run.annealer.best().tallies.violations(), 0);
}

TEST(Annealer, EndsWhereNoBeamLengthFits) {
  AnnealingOptions options = quick();
  options.lengths = {15};
  options.maxRounds = 1;
  SearchRun run(testing::squareSketch(4), options);
  run.finish(1000);
  EXPECT_TRUE(run.annealer.done());
}

struct Case {
  const char* name;
  sketch::Sketch sketch;
  int beams;  //!< at most
};

struct SolvedSketch : ::testing::TestWithParam<Case> {};

TEST_P(SolvedSketch, HasNoViolations) {
  SearchRun run(GetParam().sketch, AnnealingOptions{});
  run.finish(1000);
  EXPECT_EQ(run.annealer.best().tallies.violations(), 0);
}

TEST_P(SolvedSketch, NeedsFewBeams) {
  SearchRun run(GetParam().sketch, AnnealingOptions{});
  run.finish(1000);
  EXPECT_LE(run.annealer.best().tallies.beams, GetParam().beams);
}

INSTANTIATE_TEST_SUITE_P(Sketches,
                         SolvedSketch,
                         ::testing::Values(Case{"square", testing::squareSketch(8), 4},
                                           Case{"cube", testing::cubeSketch(8), 12},
                                           Case{"grid", testing::gridSketch(3), 8},
                                           Case{"house", testing::houseSketch(), 20}),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace liftarm::search
