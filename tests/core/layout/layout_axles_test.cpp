#include <string>

#include <gtest/gtest.h>

#include "core/helpers/layouts.h"
#include "layout/layout.h"

namespace liftarm::layout {
namespace {

using lattice::Axis;
using testing::LayoutBench;

//! Two lines along x, six modules apart, with lines along y between them: runs 0 and 1, then 2, 3.
sketch::Sketch railsSketch() {
  return testing::sketchFrom({{{0, 0, 0}, {6, 0, 0}},
                              {{0, 6, 0}, {6, 6, 0}},
                              {{1, 0, 0}, {1, 6, 0}},
                              {{5, 0, 0}, {5, 6, 0}}});
}

//! Beams on the long lines, holes along y, and axles that suit them.
void layRails(Layout* layout) {
  layout->setCover(0, {Axis::kY, {{0, 7, 0}}});
  layout->setCover(1, {Axis::kY, {{0, 7, 0}}});
  for (const int run : {2, 3}) {
    Cover cover{Axis::kZ, {}};
    cover.axle = layAxle(layout->axleSite(run), allAxleParts());
    layout->setCover(run, cover);
  }
  layout->settle();
}

TEST(LayoutWithAxles, CountsTheirPartsAsConnectors) {
  LayoutBench bench(railsSketch());
  Layout layout(bench.problem, bench.solver);
  layRails(&layout);
  EXPECT_EQ(layout.tallies().violations(), 0);
  EXPECT_EQ(layout.tallies().beams, 2);
  EXPECT_EQ(layout.tallies().axles, 2);
  EXPECT_EQ(layout.tallies().connectors,
            2 + layout.run(2).cover.axle.bushCount() + layout.run(3).cover.axle.bushCount());
  EXPECT_NEAR(layout.tallies().connectionCost, 2 * layout.run(2).cover.axle.cost(), 1e-9);
  EXPECT_EQ(layout.tallies().hinges, 0);
}

TEST(LayoutWithAxles, BeamThatMovedOffItsBushesIsNotHeld) {
  LayoutBench bench(railsSketch());
  Layout layout(bench.problem, bench.solver);
  layRails(&layout);
  layout.keep();
  // Beside its bushes on both axles, where there is nothing: it could slide.
  layout.setCover(0, {Axis::kY, {{0, 7, 2}}});
  layout.settle();
  EXPECT_EQ(layout.tallies().failedConnections, 2);
  layout.revert();
  EXPECT_EQ(layout.tallies().violations(), 0);
}

TEST(LayoutWithAxles, BeamInThePlaceOfABushCollides) {
  LayoutBench bench(railsSketch());
  Layout layout(bench.problem, bench.solver);
  layRails(&layout);
  layout.setCover(0, {Axis::kY, {{0, 7, 1}}});
  layout.settle();
  EXPECT_EQ(layout.tallies().collisions, 2);
}

TEST(LayoutWithAxles, BeamAcrossTheWayOfAnAxleCollides) {
  LayoutBench bench(railsSketch());
  Layout layout(bench.problem, bench.solver);
  layRails(&layout);
  layout.setCover(0, {Axis::kZ, {{0, 7, 0}}});
  layout.settle();
  EXPECT_EQ(layout.tallies().collisions, 2);
}

TEST(LayoutWithAxles, BeamsOfOtherPiecesAreNotGoneThrough) {
  sketch::Sketch sketch = railsSketch();
  sketch.lines.push_back(testing::sketchFrom({{{-4, 8, 0}, {4, 8, 0}}}).lines.front());
  LayoutBench bench(sketch);
  Layout layout(bench.problem, bench.solver);
  layRails(&layout);
  layout.setCover(4, {Axis::kY, {{0, 9, 0}}});
  EXPECT_EQ(layout.tallies().collisions, 0);
  Cover longer = layout.run(2).cover;
  longer.axle.part = axlePartIndex("23948");
  longer.axle.turned = false;
  layout.setCover(2, longer);
  ASSERT_GE(longer.axle.last(), 8);
  EXPECT_EQ(layout.tallies().collisions, 1);
}

TEST(LayoutWithAxles, StackOfBeamsThatOnlyAnAxleHoldsIsLoose) {
  LayoutBench bench(testing::cornerSketch(4));
  Layout layout(bench.problem, bench.solver);
  layout.setCover(0, {Axis::kZ, {{0, 5, 0}}});
  layout.setCover(1, {Axis::kZ, {{0, 5, -1}}});
  Cover cover{Axis::kX, {}};
  cover.axle = layAxle(layout.axleSite(2), allAxleParts());
  layout.setCover(2, cover);
  layout.settle();
  EXPECT_EQ(layout.tallies().violations(), 0);
  EXPECT_EQ(layout.junction(0).loose, 1);
  EXPECT_EQ(layout.tallies().hinges, 2);
}

TEST(LayoutWithAxles, BushFillsAGapInAStack) {
  LayoutBench bench(testing::cornerSketch(4));
  Layout layout(bench.problem, bench.solver);
  layout.setCover(0, {Axis::kZ, {{0, 5, 0}}});
  layout.setCover(1, {Axis::kZ, {{0, 5, -2}}});
  Cover cover{Axis::kX, {}};
  cover.axle = layAxle(layout.axleSite(2), allAxleParts());
  layout.setCover(2, cover);
  layout.settle();
  EXPECT_TRUE(cover.axle.hasBush(-1));
  EXPECT_EQ(layout.tallies().violations(), 0);
}

TEST(LayoutWithAxles, SlotsBelowTheGroundAreForbidden) {
  sketch::Sketch sketch = testing::cornerSketch(4);
  sketch.ground = 0.0;
  LayoutBench bench(sketch);
  Layout layout(bench.problem, bench.solver);
  Cover cover{Axis::kX, {}};
  cover.axle.part = axlePartIndex("44294");
  cover.axle.start = -2;
  layout.setCover(2, cover);
  EXPECT_EQ(layout.tallies().forbidden, 2);
}

struct NamedSketch {
  const char* name;
  sketch::Sketch sketch;
};

std::vector<NamedSketch> sketches() {
  sketch::Sketch boxed = testing::cornerSketch(6);
  boxed.keepOut.push_back({{2, 1, 0}, {4, 3, 2}});
  boxed.ground = 0.0;
  sketch::Sketch wheel = testing::cornerSketch(4);
  wheel.joints.push_back({{0, 0, 0}, {0, 0, 1}, {{2}, {0, 1}}});
  return {{"rails", railsSketch()},
          {"cube", testing::cubeSketch(4)},
          {"house", testing::houseSketch()},
          {"boxed", boxed},
          {"wheel", wheel}};
}

void expectSame(const Layout& layout, const Tallies& other) {
  const Tallies& t = layout.tallies();
  EXPECT_EQ(t.axles, other.axles);
  EXPECT_EQ(t.beams, other.beams);
  EXPECT_EQ(t.hinges, other.hinges);
  EXPECT_EQ(t.collisions, other.collisions);
  EXPECT_EQ(t.forbidden, other.forbidden);
  EXPECT_EQ(t.gaps, other.gaps);
  EXPECT_EQ(t.overfull, other.overfull);
  EXPECT_EQ(t.failedConnections, other.failedConnections);
  EXPECT_EQ(t.connectors, other.connectors);
  EXPECT_EQ(t.mechanisms, other.mechanisms);
  EXPECT_EQ(t.mechanismCells, other.mechanismCells);
  EXPECT_NEAR(t.connectionCost, other.connectionCost, 1e-6);
}

//! Beams or axles on a few runs.
void coverSome(Layout* layout, std::uint32_t most, base::Rng* rng) {
  const std::vector<guide::GuideRun>& runs = layout->problem().graph.runs;
  for (std::uint32_t i = 1 + rng->below(most); i > 0; --i) {
    const auto run = static_cast<int>(rng->below(static_cast<std::uint32_t>(runs.size())));
    const guide::GuideRun& guideRun = runs[static_cast<std::size_t>(run)];
    const bool axle = guideRun.principal && rng->below(2) == 0;
    layout->setCover(
        run, axle ? testing::randomAxle(*layout, run, rng) : testing::randomCover(guideRun, rng));
  }
}

struct AxleEdits : ::testing::TestWithParam<NamedSketch> {};

TEST_P(AxleEdits, TalliesEqualARecount) {
  LayoutBench bench(GetParam().sketch);
  Layout layout(bench.problem, bench.solver);
  base::Rng rng(21);
  int axles = 0;
  for (int step = 0; step < 80; ++step) {
    coverSome(&layout, 3, &rng);
    layout.settle();
    axles += layout.tallies().axles;
    if (rng.below(2) == 0) {
      layout.keep();
    } else {
      layout.revert();
    }
    expectSame(layout, layout.recount());
    ASSERT_FALSE(HasFailure()) << "after step " << step;
  }
  EXPECT_GT(axles, 20);
}

TEST_P(AxleEdits, RevertRestoresEverything) {
  LayoutBench bench(GetParam().sketch);
  Layout layout(bench.problem, bench.solver);
  base::Rng rng(22);
  coverSome(&layout, 12, &rng);
  layout.settleAll();
  layout.keep();
  for (int step = 0; step < 60; ++step) {
    const std::string before = testing::fingerprint(layout);
    coverSome(&layout, 3, &rng);
    if (rng.below(3) != 0) {
      layout.settle();
    }
    layout.revert();
    ASSERT_EQ(testing::fingerprint(layout) == before, true) << "after step " << step;
  }
}

TEST_P(AxleEdits, NothingStaleIsLeft) {
  // What does not depend on the order in which junctions are solved is as if all were solved anew.
  LayoutBench bench(GetParam().sketch);
  Layout layout(bench.problem, bench.solver);
  base::Rng rng(23);
  for (int step = 0; step < 40; ++step) {
    coverSome(&layout, 2, &rng);
    layout.settle();
    layout.keep();
    std::vector<JunctionState> settled;
    for (std::size_t j = 0; j < bench.problem.graph.junctions.size(); ++j) {
      settled.push_back(layout.junction(static_cast<int>(j)));
    }
    layout.settleAll();
    layout.keep();
    for (std::size_t j = 0; j < settled.size(); ++j) {
      EXPECT_EQ(layout.junction(static_cast<int>(j)).loose, settled[j].loose) << "step " << step;
      EXPECT_EQ(layout.junction(static_cast<int>(j)).gaps, settled[j].gaps) << "step " << step;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sketches,
                         AxleEdits,
                         ::testing::ValuesIn(sketches()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace liftarm::layout
