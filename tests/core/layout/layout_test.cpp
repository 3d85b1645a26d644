#include "layout/layout.h"

#include <gtest/gtest.h>

#include "core/helpers/layouts.h"

namespace liftarm::layout {
namespace {

using testing::fingerprint;
using testing::LayoutBench;
using testing::randomCover;
using testing::structureOf;

struct SmallSketch {
  const char* name;
  sketch::Sketch sketch;
};

std::vector<SmallSketch> smallSketches() {
  sketch::Sketch boxed = testing::cornerSketch(6);
  boxed.keepOut.push_back({{2, 1, 0}, {4, 3, 2}});
  boxed.ground = 0.0;
  return {{"square", testing::squareSketch(8)},
          {"corner", testing::cornerSketch(5)},
          {"triangle", testing::triangleSketch(2)},
          {"grid", testing::gridSketch(2)},
          {"cube", testing::cubeSketch(6)},
          {"house", testing::houseSketch()},
          {"seesaw", testing::seesawSketch()},
          {"boxed", boxed}};
}

std::string nameOf(const ::testing::TestParamInfo<SmallSketch>& info) {
  return info.param.name;
}

void expectEqual(const Tallies& a, const Tallies& b) {
  EXPECT_EQ(a.beams, b.beams);
  EXPECT_EQ(a.holes, b.holes);
  EXPECT_EQ(a.layerSquares, b.layerSquares);
  EXPECT_EQ(a.overhang, b.overhang);
  EXPECT_EQ(a.hinges, b.hinges);
  EXPECT_EQ(a.collisions, b.collisions);
  EXPECT_EQ(a.forbidden, b.forbidden);
  EXPECT_EQ(a.gaps, b.gaps);
  EXPECT_EQ(a.overfull, b.overfull);
  EXPECT_EQ(a.failedConnections, b.failedConnections);
  EXPECT_EQ(a.connectors, b.connectors);
  EXPECT_EQ(a.mechanisms, b.mechanisms);
  EXPECT_EQ(a.mechanismHeads, b.mechanismHeads);
  EXPECT_EQ(a.mechanismCells, b.mechanismCells);
  EXPECT_NEAR(a.pinHeadRatios, b.pinHeadRatios, 1e-6);
  EXPECT_NEAR(a.connectionCost, b.connectionCost, 1e-6);
}

void coverAll(Layout* layout, base::Rng* rng) {
  const std::vector<guide::GuideRun>& runs = layout->problem().graph.runs;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    layout->setCover(static_cast<int>(r), randomCover(runs[r], rng));
  }
  layout->settleAll();
  layout->keep();
}

void coverSome(Layout* layout, base::Rng* rng) {
  const std::vector<guide::GuideRun>& runs = layout->problem().graph.runs;
  const std::uint32_t count = 1 + rng->below(3);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto run = static_cast<int>(rng->below(static_cast<std::uint32_t>(runs.size())));
    const guide::GuideRun& guideRun = runs[static_cast<std::size_t>(run)];
    layout->setCover(
        run, rng->below(6) == 0 ? Cover{guideRun.axes.front(), {}} : randomCover(guideRun, rng));
  }
}

struct LayoutEdits : ::testing::TestWithParam<SmallSketch> {};

TEST_P(LayoutEdits, TalliesEqualARecountAfterAnyEdits) {
  LayoutBench bench(GetParam().sketch);
  Layout layout(bench.problem, bench.solver);
  base::Rng rng(11);
  coverAll(&layout, &rng);
  for (int step = 0; step < 60; ++step) {
    coverSome(&layout, &rng);
    layout.settle();
    if (rng.below(2) == 0) {
      layout.keep();
    } else {
      layout.revert();
    }
    expectEqual(layout.tallies(), layout.recount());
    if (HasFailure()) {
      FAIL() << "after step " << step;
    }
  }
}

//! Which body each beam is of: its own, or all the same.
std::vector<std::vector<int>> bodiesOf(const Layout& layout, bool apart) {
  std::vector<std::vector<int>> bodies;
  int next = 0;
  for (std::size_t r = 0; r < layout.problem().graph.runs.size(); ++r) {
    bodies.emplace_back(layout.run(static_cast<int>(r)).cover.beams.size(), 0);
    for (int& body : bodies.back()) {
      body = apart ? next++ : 0;
    }
  }
  return bodies;
}

//! Cells of a mechanism, seen from its junction.
std::vector<lattice::Cell> cellsOf(const Layout& layout, const PlacedMechanism& placed) {
  std::vector<lattice::Cell> cells;
  for (const mechanisms::MechanismCell& cell :
       layout.table().oriented(placed.oriented).shape.cells) {
    cells.push_back(cell.at + placed.at);
  }
  return cells;
}

TEST_P(LayoutEdits, FurtherJoinsKeepOutOfWhatJoinsTheBeamsAlready) {
  LayoutBench bench(GetParam().sketch);
  Layout layout(bench.problem, bench.solver);
  base::Rng rng(17);
  coverAll(&layout, &rng);
  for (std::size_t j = 0; j < bench.problem.graph.junctions.size(); ++j) {
    const auto junction = static_cast<int>(j);
    for (const FurtherJoin& join : layout.furtherJoins(junction, bodiesOf(layout, true), 50)) {
      for (const PlacedMechanism& there : layout.junction(junction).connection.mechanisms) {
        for (const lattice::Cell own : cellsOf(layout, join.placed)) {
          for (const lattice::Cell other : cellsOf(layout, there)) {
            EXPECT_FALSE(own == other);
          }
        }
      }
    }
  }
}

TEST_P(LayoutEdits, FurtherJoinsAreNoneWithinOneBody) {
  LayoutBench bench(GetParam().sketch);
  Layout layout(bench.problem, bench.solver);
  base::Rng rng(18);
  coverAll(&layout, &rng);
  for (std::size_t j = 0; j < bench.problem.graph.junctions.size(); ++j) {
    EXPECT_TRUE(layout.furtherJoins(static_cast<int>(j), bodiesOf(layout, false), 50).empty());
  }
}

TEST_P(LayoutEdits, AnAddedMechanismIsInTheTallies) {
  LayoutBench bench(GetParam().sketch);
  Layout layout(bench.problem, bench.solver);
  base::Rng rng(19);
  coverAll(&layout, &rng);
  for (std::size_t j = 0; j < bench.problem.graph.junctions.size(); ++j) {
    const auto junction = static_cast<int>(j);
    const int before = layout.tallies().mechanisms;
    const std::vector<FurtherJoin> joins =
        layout.furtherJoins(junction, bodiesOf(layout, true), 50);
    if (!joins.empty()) {
      layout.addMechanism(junction, joins.front());
      EXPECT_EQ(layout.tallies().mechanisms, before + 1);
      expectEqual(layout.tallies(), layout.recount());
    }
  }
}

TEST_P(LayoutEdits, RestoreBringsAKeptLayoutBack) {
  LayoutBench bench(GetParam().sketch);
  Layout layout(bench.problem, bench.solver);
  base::Rng rng(14);
  coverAll(&layout, &rng);
  layout.settle();
  layout.keep();
  std::vector<Cover> covers;
  std::vector<JunctionState> junctions;
  for (std::size_t r = 0; r < bench.problem.graph.runs.size(); ++r) {
    covers.push_back(layout.run(static_cast<int>(r)).cover);
  }
  for (std::size_t j = 0; j < bench.problem.graph.junctions.size(); ++j) {
    junctions.push_back(layout.junction(static_cast<int>(j)));
  }
  const std::string before = structureOf(layout);
  const Tallies tallies = layout.tallies();
  for (int step = 0; step < 5; ++step) {
    coverSome(&layout, &rng);
    layout.settle();
    layout.keep();
  }
  layout.restore(covers, junctions);
  EXPECT_EQ(structureOf(layout) == before, true);
  expectEqual(layout.tallies(), tallies);
}

TEST_P(LayoutEdits, RevertRestoresEverything) {
  LayoutBench bench(GetParam().sketch);
  Layout layout(bench.problem, bench.solver);
  base::Rng rng(12);
  coverAll(&layout, &rng);
  for (int step = 0; step < 60; ++step) {
    const std::string before = fingerprint(layout);
    coverSome(&layout, &rng);
    if (rng.below(3) != 0) {
      layout.settle();
    }
    layout.revert();
    ASSERT_EQ(fingerprint(layout) == before, true) << "after step " << step;
  }
}

TEST_P(LayoutEdits, RevertLeavesNoTraceInLaterEdits) {
  LayoutBench bench(GetParam().sketch);
  LayoutBench other(GetParam().sketch);
  Layout layout(bench.problem, bench.solver);
  Layout straight(other.problem, other.solver);
  base::Rng rng(13);
  base::Rng same(13);
  coverAll(&layout, &rng);
  coverAll(&straight, &same);
  for (int step = 0; step < 20; ++step) {
    base::Rng detour(static_cast<std::uint64_t>(step));
    coverSome(&layout, &detour);
    layout.settle();
    layout.revert();
    coverSome(&layout, &rng);
    coverSome(&straight, &same);
    layout.settle();
    straight.settle();
    layout.keep();
    straight.keep();
  }
  expectEqual(layout.tallies(), straight.tallies());
}

TEST_P(LayoutEdits, WeightedViolationsAreTheViolationsWhereAllWeightsAreOne) {
  LayoutBench bench(GetParam().sketch);
  Layout layout(bench.problem, bench.solver);
  base::Rng rng(14);
  coverAll(&layout, &rng);
  for (int step = 0; step < 30; ++step) {
    coverSome(&layout, &rng);
    layout.settle();
    layout.keep();
    EXPECT_NEAR(layout.weightedViolations(), layout.tallies().violations(), 1e-6);
  }
}

TEST_P(LayoutEdits, RunCollisionsSumToTwiceThePairs) {
  LayoutBench bench(GetParam().sketch);
  Layout layout(bench.problem, bench.solver);
  base::Rng rng(15);
  coverAll(&layout, &rng);
  int sum = 0;
  for (std::size_t r = 0; r < bench.problem.graph.runs.size(); ++r) {
    sum += layout.run(static_cast<int>(r)).collisions;
  }
  EXPECT_EQ(sum, 2 * layout.tallies().collisions);
}

TEST_P(LayoutEdits, SettlingFromScratchIsTheSameTwice) {
  LayoutBench bench(GetParam().sketch);
  Layout layout(bench.problem, bench.solver);
  base::Rng rng(16);
  coverAll(&layout, &rng);
  layout.settleAll();
  layout.keep();
  const std::string once = testing::structureOf(layout);
  layout.settleAll();
  layout.keep();
  EXPECT_EQ(testing::structureOf(layout) == once, true);
}

INSTANTIATE_TEST_SUITE_P(Sketches, LayoutEdits, ::testing::ValuesIn(smallSketches()), nameOf);

TEST(Layout, OfStackedBeamsHasOnePinInEachCorner) {
  LayoutBench bench(testing::squareSketch(8));
  Layout layout(bench.problem, bench.solver);
  for (int r = 0; r < 4; ++r) {
    const bool alongX = bench.problem.graph.runs[static_cast<std::size_t>(r)].direction.y == 0.0;
    layout.setCover(r, {lattice::Axis::kZ, {{0, 9, alongX ? 0 : 1}}});
  }
  layout.settle();
  EXPECT_EQ(layout.tallies().violations(), 0);
  EXPECT_EQ(layout.tallies().beams, 4);
  EXPECT_EQ(layout.tallies().connectors, 4);
  EXPECT_DOUBLE_EQ(layout.tallies().pinHeadRatios, 4.0);
}

TEST(Layout, BeamsOfOneLayerCollideInEveryCorner) {
  LayoutBench bench(testing::squareSketch(8));
  Layout layout(bench.problem, bench.solver);
  for (int r = 0; r < 4; ++r) {
    layout.setCover(r, {lattice::Axis::kZ, {{0, 9, 0}}});
  }
  layout.settle();
  EXPECT_EQ(layout.tallies().collisions, 4);
}

TEST(Layout, EmptyLayerBetweenStackedBeamsIsAGap) {
  LayoutBench bench(testing::teeSketch());
  bench.problem.spacers = false;
  Layout layout(bench.problem, bench.solver);
  layout.setCover(0, {lattice::Axis::kZ, {{0, 9, -1}}});
  layout.setCover(1, {lattice::Axis::kZ, {{0, 7, 1}}});
  layout.settle();
  EXPECT_EQ(layout.tallies().gaps, 1);
}

TEST(Layout, BeamOfSixHolesCountsTwoParts) {
  LayoutBench bench(testing::lineSketch(5));
  Layout layout(bench.problem, bench.solver);
  layout.setCover(0, {lattice::Axis::kZ, {{0, 6, 0}}});
  layout.settle();
  EXPECT_EQ(layout.tallies().beams, 2);
}

TEST(Layout, BeamsInLineThatShareOneHoleAreAHinge) {
  LayoutBench bench(testing::lineSketch(8));
  Layout layout(bench.problem, bench.solver);
  layout.setCover(0, {lattice::Axis::kZ, {{0, 5, 0}, {4, 5, 1}}});
  layout.settle();
  EXPECT_EQ(layout.tallies().hinges, 1);
  EXPECT_EQ(layout.tallies().connectors, 1);
}

TEST(Layout, HolesBelowTheGroundAreForbidden) {
  sketch::Sketch sketch = testing::lineSketch(4);
  sketch.ground = 0.0;
  LayoutBench bench(sketch);
  Layout layout(bench.problem, bench.solver);
  layout.setCover(0, {lattice::Axis::kZ, {{0, 5, -1}}});
  layout.settle();
  EXPECT_EQ(layout.tallies().forbidden, 5);
}

}  // namespace
}  // namespace liftarm::layout
