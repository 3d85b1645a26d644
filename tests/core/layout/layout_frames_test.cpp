#include <gtest/gtest.h>

#include "core/helpers/frame_sketches.h"
#include "core/helpers/layouts.h"
#include "layout/frame_beam.h"
#include "layout/layout.h"

namespace liftarm::layout {
namespace {

using lattice::Axis;
using testing::fingerprint;
using testing::LayoutBench;

int siteOf(const LayoutProblem& problem, const std::string& part) {
  for (std::size_t s = 0; s < problem.sites.size(); ++s) {
    if (frameBeams()[static_cast<std::size_t>(problem.sites[s].frame)].part == part) {
      return static_cast<int>(s);
    }
  }
  ADD_FAILURE() << "no site for " << part;
  return -1;
}

//! Lays a frame on a layer, alone on its runs.
void layFrame(Layout* layout, int site, int layer) {
  for (const SiteArm& arm : layout->problem().sites[static_cast<std::size_t>(site)].arms) {
    Cover cover{layout->problem().sites[static_cast<std::size_t>(site)].axis, {arm.beam}};
    cover.beams.front().layer = layer;
    layout->setCover(arm.run, cover);
  }
}

TEST(LayoutFrames, AFrameIsOneBeamWithoutConnectionsAndViolations) {
  for (const auto& [sketch, part] :
       {std::pair(testing::rectangleSketch(4, 6), std::string("64179")),
        std::pair(testing::smallHSketch(), std::string("14720")),
        std::pair(testing::ladderSketch(), std::string("64178"))}) {
    LayoutBench bench(sketch);
    Layout layout(bench.problem, bench.solver);
    layFrame(&layout, siteOf(bench.problem, part), 1);
    layout.settleAll();
    EXPECT_EQ(layout.tallies().beams, 1) << part;
    EXPECT_EQ(layout.tallies().connectors, 0) << part;
    EXPECT_EQ(layout.tallies().violations(), 0) << part;
    EXPECT_EQ(layout.tallies().holes,
              static_cast<int>(parts::Catalogue::builtIn().find(part)->features.size()))
        << part;
    EXPECT_EQ(layout.tallies().layerSquares, layout.tallies().holes) << part;
  }
}

TEST(LayoutFrames, TalliesEqualARecountAndRevertBringsBackWhatWas) {
  for (const sketch::Sketch& sketch : {testing::benchSketch(), testing::gridSketch(2)}) {
    LayoutBench bench(sketch);
    Layout layout(bench.problem, bench.solver);
    base::Rng rng(3);
    const auto& runs = bench.problem.graph.runs;
    for (std::size_t r = 0; r < runs.size(); ++r) {
      layout.setCover(static_cast<int>(r), testing::randomCover(runs[r], &rng));
    }
    layout.settleAll();
    layout.keep();
    for (int step = 0; step < 40; ++step) {
      const std::string before = fingerprint(layout);
      const auto sites = static_cast<std::uint32_t>(bench.problem.sites.size());
      const auto site = static_cast<int>(rng.below(sites));
      // What lies on the runs of another frame goes, or half of that would stay.
      for (std::size_t r = 0; r < runs.size(); ++r) {
        layout.setCover(static_cast<int>(r), testing::randomCover(runs[r], &rng));
      }
      layFrame(&layout, site, static_cast<int>(rng.below(5)) - 2);
      layout.settle();
      const Tallies again = layout.recount();
      EXPECT_EQ(layout.tallies().beams, again.beams);
      EXPECT_EQ(layout.tallies().holes, again.holes);
      EXPECT_EQ(layout.tallies().hinges, again.hinges);
      EXPECT_EQ(layout.tallies().collisions, again.collisions);
      EXPECT_EQ(layout.tallies().forbidden, again.forbidden);
      EXPECT_EQ(layout.tallies().gaps, again.gaps);
      EXPECT_NEAR(layout.tallies().connectionCost, again.connectionCost, 1e-6);
      if (rng.below(2) == 0) {
        layout.keep();
      } else {
        layout.revert();
        EXPECT_EQ(fingerprint(layout), before);
      }
    }
  }
}

TEST(LayoutFrames, ALegIsPinnedToTheHoleAcrossABar) {
  LayoutBench bench(testing::benchSketch());
  Layout layout(bench.problem, bench.solver);
  layFrame(&layout, siteOf(bench.problem, "64179"), 0);
  for (std::size_t r = 0; r < bench.problem.graph.runs.size(); ++r) {
    if (bench.problem.graph.runs[r].direction.z > 0.5) {
      layout.setCover(static_cast<int>(r), {Axis::kX, {{0, 7, 1}}});
    }
  }
  layout.settleAll();
  EXPECT_EQ(layout.tallies().violations(), 0);
  EXPECT_EQ(layout.tallies().connectors, 2);  // a pin for each leg
}

//! A frame's two bars, four modules apart with holes across, and a beam above their middle.
LocalProblem betweenBars() {
  LocalProblem problem;
  problem.clear();
  problem.terminals = 2;
  for (const int x : {0, 4}) {
    for (int z = -2; z <= 2; ++z) {
      problem.addHole({{x, 0, z}, Axis::kX, 0, false});
    }
  }
  for (int x = 0; x <= 4; ++x) {
    problem.addHole({{x, 1, 0}, Axis::kY, 1, false});
  }
  return problem;
}

TEST(LayoutFrames, WhatStandsBetweenTwoBarsHasRoomToDrawBack) {
  ConnectionSolver solver(testing::defaultTable());
  const auto isFrame = [](lattice::Cell cell) {
    return (cell.x == 0 || cell.x == 4) && cell.y == 0 && cell.z >= -2 && cell.z <= 2;
  };
  LocalProblem problem = betweenBars();
  problem.frames = 1U;
  const Connection connection = solver.solve(problem);
  for (const PlacedMechanism& placed : connection.mechanisms) {
    const mechanisms::OrientedMechanism& m = testing::defaultTable().oriented(placed.oriented);
    bool atZero = false;
    bool atFour = false;
    for (const mechanisms::MechanismCell& cell : m.shape.cells) {
      const lattice::Cell at = cell.at + placed.at;
      atZero = atZero || (isFrame(at) && at.x == 0) ||
               (!cell.head && isFrame(at - lattice::Cell{1, 0, 0}));
      atFour = atFour || (isFrame(at) && at.x == 4) ||
               (!cell.head && isFrame(at + lattice::Cell{1, 0, 0}));
    }
    EXPECT_FALSE(atZero && atFour);
  }
}

TEST(LayoutFrames, ABeamInLineIsPinnedWhereBothHaveAHoleOnly) {
  // A rail of 20: the frame ends at 10, and has holes along its normal at 8 and 6, not at 9 and 10.
  const sketch::Sketch sketch = testing::sketchFrom({{{0, 0, 0}, {20, 0, 0}},
                                                     {{0, 4, 0}, {10, 4, 0}},
                                                     {{2, 0, 0}, {2, 4, 0}},
                                                     {{8, 0, 0}, {8, 4, 0}}});
  LayoutBench bench(sketch);
  const int site = siteOf(bench.problem, "64178");
  const auto forbidden = [&](int start, int holes) {
    Layout layout(bench.problem, bench.solver);
    layFrame(&layout, site, 0);
    Cover cover = layout.run(0).cover;
    cover.beams.push_back({start, holes, 1});
    layout.setCover(0, cover);
    layout.settleAll();
    return layout.tallies().forbidden;
  };
  ASSERT_EQ(bench.problem.graph.runs[0].edgeCount(), 20);
  EXPECT_EQ(forbidden(10, 11), 1);
  EXPECT_EQ(forbidden(9, 13), 1);
  EXPECT_EQ(forbidden(8, 13), 0);
}

TEST(LayoutFrames, AStackWithoutAHoleInTheMiddleHasAGap) {
  LayoutBench bench(testing::sketchFrom({{{0, 0, 0}, {4, 0, 0}},
                                         {{4, 0, 0}, {4, 6, 0}},
                                         {{4, 6, 0}, {0, 6, 0}},
                                         {{0, 6, 0}, {0, 0, 0}},
                                         {{-4, 3, 0}, {8, 3, 0}}}));
  Layout layout(bench.problem, bench.solver);
  layFrame(&layout, siteOf(bench.problem, "64179"), 0);
  for (std::size_t r = 0; r < bench.problem.graph.runs.size(); ++r) {
    if (bench.problem.graph.runs[r].edgeCount() == 12) {
      layout.setCover(static_cast<int>(r), {Axis::kZ, {{0, 9, -1}, {8, 5, 1}}});
    }
  }
  layout.settleAll();
  EXPECT_EQ(layout.tallies().gaps, 1);  // one beam on either side of it, and none at its other bar
}

}  // namespace
}  // namespace liftarm::layout
