#include "search/moves.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "core/helpers/frame_sketches.h"
#include "core/helpers/layouts.h"
#include "search/phase_first_layout.h"

// Moves, each for itself, on a first layout.

namespace liftarm::search {
namespace {

struct MoveBench {
  explicit MoveBench(const sketch::Sketch& sketch, AnnealingOptions options = {})
      : bench(sketch), state(bench.problem, bench.solver, std::move(options)) {
    FirstLayout(state).begin();
  }

  [[nodiscard]] int runs() const { return static_cast<int>(bench.problem.graph.runs.size()); }

  testing::LayoutBench bench;
  SearchState state;
};

MoveContext at(int run) {
  MoveContext context;
  context.pick.run = run;
  return context;
}

TEST(MoveTable, NamesEachMoveOnce) {
  std::set<std::string_view> names;
  for (const Move& move : moveTable()) {
    EXPECT_TRUE(names.insert(move.name).second) << move.name;
  }
}

TEST(MoveTable, SwitchesEachMoveButTheLastByItsName) {
  for (const Move& move : moveTable().first(moveTable().size() - 1)) {
    bool found = false;
    for (const SearchSwitch& part : kSearchSwitches) {
      found = found || (part.name == move.name && part.part == move.part);
    }
    EXPECT_TRUE(found) << move.name;
  }
  EXPECT_EQ(moveTable().back().part, nullptr);
}

TEST(MoveTable, EndsWithAMoveThatAlwaysApplies) {
  MoveBench bench(testing::cubeSketch(4));
  MoveContext calm = at(0);
  calm.calm = true;
  EXPECT_TRUE(moveTable().back().applies(bench.state, calm));
  EXPECT_GE(moveTable().back().weight, 1.0);
}

TEST(MoveTable, LeavesWhatGrewInPeace) {
  MoveBench bench(testing::gridSketch(3));
  ASSERT_EQ(bench.state.layout().tallies().violations(), 0);
  MoveContext calm = at(0);
  calm.calm = true;
  for (const Move& move : moveTable().first(moveTable().size() - 1)) {
    EXPECT_FALSE(move.applies(bench.state, calm)) << move.name;
  }
}

TEST(Moves, LeaveNothingBehindWhenReverted) {
  MoveBench bench(testing::houseSketch());
  const std::string before = testing::structureOf(bench.state.layout());
  for (const Move& move : moveTable()) {
    for (int run = 0; run < bench.runs(); ++run) {
      if (move.applies(bench.state, at(run))) {
        move.apply(bench.state, at(run));
        bench.state.layout().revert();
        ASSERT_EQ(testing::structureOf(bench.state.layout()), before) << move.name;
      }
    }
  }
}

TEST(Moves, KeepTheTalliesOfWhatTheyLay) {
  MoveBench bench(testing::houseSketch());
  for (const Move& move : moveTable()) {
    for (int run = 0; run < bench.runs(); ++run) {
      if (move.applies(bench.state, at(run)) && move.apply(bench.state, at(run))) {
        bench.state.layout().settle();
        bench.state.layout().keep();
        ASSERT_EQ(bench.state.layout().tallies().beams, bench.state.layout().recount().beams);
      }
    }
  }
}

TEST(MirrorLayers, LeavesExactLinesAlone) {
  sketch::Sketch sketch = testing::squareSketch(8);
  sketch.lines[0].exact = true;
  MoveBench bench(sketch);
  int exact = 0;
  for (int run = 0; run < bench.runs(); ++run) {
    if (bench.bench.problem.graph.runs[static_cast<std::size_t>(run)].exact) {
      EXPECT_FALSE(mirrorLayers(bench.state, at(run)));
      ++exact;
    }
  }
  EXPECT_EQ(exact, 1);
}

TEST(ShiftPlane, KeepsEveryBeamInItsPlaceAlongItsLine) {
  MoveBench bench(testing::gridSketch(3));
  const LayoutSnapshot before = bench.state.snapshot();
  bool shifted = false;
  for (int i = 0; i < 20 && !shifted; ++i) {
    shifted = shiftPlane(bench.state, at(0));
  }
  ASSERT_TRUE(shifted);
  int moved = 0;
  for (int run = 0; run < bench.runs(); ++run) {
    const layout::Cover& old = before.covers[static_cast<std::size_t>(run)];
    const layout::Cover& now = bench.state.coverOf(run);
    ASSERT_EQ(old.beams.size(), now.beams.size());
    for (std::size_t b = 0; b < now.beams.size(); ++b) {
      EXPECT_EQ(old.beams[b].start, now.beams[b].start);
      EXPECT_EQ(old.beams[b].holes, now.beams[b].holes);
      moved += old.beams[b].layer == now.beams[b].layer ? 0 : 1;
    }
  }
  EXPECT_GT(moved, 0);
}

TEST(LayFrame, LaysBarsOnAllRunsOfASite) {
  MoveBench bench(testing::rectangleSketch(4, 6));
  ASSERT_FALSE(bench.state.frames().useful().empty());
  ASSERT_TRUE(layFrame(bench.state, at(0)));
  EXPECT_TRUE(hasFrame(bench.state.snapshot()));
}

TEST(LayBend, LaysAnArmOnBothRuns) {
  MoveBench bench(testing::cornerSketch(6));
  bool laid = false;
  for (int i = 0; i < 50 && !laid; ++i) {
    laid = layBend(bench.state, at(0));
  }
  ASSERT_TRUE(laid);
  int arms = 0;
  for (int run = 0; run < bench.runs(); ++run) {
    arms += static_cast<int>(layout::armsOf(bench.state.coverOf(run)).size());
  }
  EXPECT_EQ(arms, 2);
}

TEST(CoverRequest, LeavesNothingBehindForTheNextOne) {
  testing::LayoutBench bench(testing::lineSketch(12));
  layout::Layout layout(bench.problem, bench.solver);
  RunCoverer coverer(bench.problem, {3, 5, 7}, CoverCosts{});
  base::Rng rng(1);
  const auto plain = coverer.propose(layout, {0, lattice::Axis::kZ}, &rng);
  const layout::Beam fixed{0, 7, 1};
  const std::vector<double> dear{1000.0, 1000.0, 0.0};
  coverer.propose(layout, {0, lattice::Axis::kZ, {0.0, 1}, {&fixed, 1}, {}, dear}, &rng);
  EXPECT_EQ(coverer.propose(layout, {0, lattice::Axis::kZ}, &rng), plain);
}

}  // namespace
}  // namespace liftarm::search
