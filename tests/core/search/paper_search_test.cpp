#include "search/paper_search.h"

#include <gtest/gtest.h>

#include "core/helpers/layouts.h"

namespace liftarm::search {
namespace {

using lattice::Axis;
using testing::LayoutBench;

//! A search that ends after some hundred moves, with all that it refers to.
struct PaperRun {
  explicit PaperRun(const sketch::Sketch& sketch, std::uint64_t seed = 1)
      : bench(sketch), search(bench.problem, bench.solver, quick(seed)) {}

  static PaperOptions quick(std::uint64_t seed) {
    PaperOptions options;
    options.seed = seed;
    options.coolingRate = 0.98;
    return options;
  }

  const LayoutSnapshot& finish(std::uint32_t slice = 100000) {
    while (!search.advance(slice)) {
    }
    return search.best();
  }

  LayoutBench bench;
  PaperSearch search;
};

bool sameCovers(const LayoutSnapshot& a, const LayoutSnapshot& b) {
  return a.covers == b.covers && a.energy == b.energy;
}

TEST(PaperSearch, GivesTheSameResultForTheSameSeed) {
  PaperRun a(testing::houseSketch(), 5);
  PaperRun b(testing::houseSketch(), 5);
  EXPECT_TRUE(sameCovers(a.finish(), b.finish()));
}

TEST(PaperSearch, GivesTheSameResultInSlicesOfAnySize) {
  PaperRun whole(testing::cubeSketch(6));
  PaperRun sliced(testing::cubeSketch(6));
  EXPECT_TRUE(sameCovers(whole.finish(), sliced.finish(7)));
}

TEST(PaperSearch, TakesAsManyMovesAsItsScheduleSays) {
  PaperRun run(testing::squareSketch(4));
  run.finish();
  // 2000 * 0.98^n first falls to 1e-4 at n = 833.
  EXPECT_EQ(run.search.iterations(), 833U);
  EXPECT_EQ(run.search.fraction(), 1.0);
}

TEST(PaperSearch, CoolsSlowlierWhereTheSketchIsComplex) {
  LayoutBench simple(testing::squareSketch(4));
  LayoutBench complex(testing::gridSketch(8));
  PaperSearch a(simple.problem, simple.solver, {});
  PaperSearch b(complex.problem, complex.solver, {});
  a.advance(1);
  b.advance(1);
  EXPECT_LT(a.temperature(), b.temperature());
}

TEST(PaperSearch, KeepsTalliesThatBelongToItsBestLayout) {
  PaperRun run(testing::houseSketch(), 4);
  const LayoutSnapshot& best = run.finish();
  layout::Layout layout(run.bench.problem, run.bench.solver);
  for (std::size_t r = 0; r < best.covers.size(); ++r) {
    layout.setCover(static_cast<int>(r), best.covers[r]);
  }
  EXPECT_EQ(layout.tallies().beams, best.tallies.beams);
  EXPECT_EQ(layout.tallies().holes, best.tallies.holes);
  EXPECT_LE(layout.tallies().collisions, best.tallies.collisions);
}

TEST(PaperSearch, KeepsBeamsOnAnExactLine) {
  sketch::Sketch sketch = testing::gridSketch(2);
  sketch.lines[2].exact = true;
  PaperRun run(sketch);
  EXPECT_EQ(run.finish().tallies.forbidden, 0);
}

TEST(PaperSearch, SolvesASquareWithoutViolations) {
  PaperRun run(testing::squareSketch(8));
  EXPECT_EQ(run.finish().tallies.violations(), 0);
}

TEST(PaperStageOne, CountsEdgesToNodesOfAnotherAxis) {
  const guide::GuidingGraph graph = testing::graphOf(testing::teeSketch());
  ASSERT_EQ(graph.junctions.size(), 1U);
  guide::Orientation runs;
  for (const guide::GuideRun& run : graph.runs) {
    const bool bar = run.direction.x != 0.0;
    runs.push_back(bar ? Axis::kY : Axis::kX);
  }
  // The bar goes on to both sides of the junction, the stem to one.
  EXPECT_EQ(axisDifferences(graph, runs, graph.junctions[0], Axis::kY), 1);
  EXPECT_EQ(axisDifferences(graph, runs, graph.junctions[0], Axis::kX), 2);
  EXPECT_EQ(axisDifferences(graph, runs, graph.junctions[0], Axis::kZ), 3);
  EXPECT_EQ(junctionAxis(graph, runs, graph.junctions[0]), Axis::kY);
}

TEST(PaperStageOne, TurnsTranslatedLinesTogether) {
  sketch::Sketch sketch = testing::sketchFrom({{{0, 0, 0}, {6, 0, 0}}, {{0, 9, 0}, {6, 9, 0}}});
  sketch::Symmetry symmetry;
  symmetry.kind = sketch::Symmetry::Kind::kTranslation;
  symmetry.vector = {0, 9, 0};
  symmetry.pairs = {{0, 1}};
  sketch.symmetries = {symmetry};
  const guide::GuidingGraph graph = testing::graphOf(sketch);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    base::Rng rng(seed);
    const PaperOrientation orientation = paperStageOne(graph, &rng);
    EXPECT_EQ(orientation.runs[0], orientation.runs[1]) << "seed " << seed;
  }
}

TEST(PaperStageOne, MirrorsTheAxisOfALineAcrossADiagonalPlane) {
  // Along z, left and right of the plane x = y: holes along x answer to holes along y.
  sketch::Sketch sketch = testing::sketchFrom({{{0, 5, 0}, {0, 5, 6}}, {{5, 0, 0}, {5, 0, 6}}});
  sketch::Symmetry symmetry;
  symmetry.kind = sketch::Symmetry::Kind::kReflection;
  symmetry.normal = lattice::normalized({1, -1, 0});
  sketch.symmetries = {symmetry};
  const guide::GuidingGraph graph = testing::graphOf(sketch);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    base::Rng rng(seed);
    const PaperOrientation orientation = paperStageOne(graph, &rng);
    EXPECT_NE(orientation.runs[0], orientation.runs[1]) << "seed " << seed;
  }
}

}  // namespace
}  // namespace liftarm::search
