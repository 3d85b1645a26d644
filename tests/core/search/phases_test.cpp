#include <gtest/gtest.h>

#include "core/helpers/layouts.h"
#include "search/phase_axles.h"
#include "search/phase_earlier.h"
#include "search/phase_first_layout.h"
#include "search/phase_holds.h"
#include "search/phase_rounds.h"
#include "search/phase_stiffen.h"

// Phases, each for itself: what it does to the state when it begins, and what it says comes next.

namespace liftarm::search {
namespace {

//! A state with all that it refers to.
struct StateBench {
  explicit StateBench(const sketch::Sketch& sketch, AnnealingOptions options = {})
      : bench(sketch), state(bench.problem, bench.solver, std::move(options)) {}

  testing::LayoutBench bench;
  SearchState state;
};

//! Whether a phase of this kind comes next.
template <typename Kind>
bool leadsTo(const Next& next, SearchState& state) {
  const NextPhase* phase = std::get_if<NextPhase>(&next);
  return phase != nullptr && dynamic_cast<Kind*>(phase->make(state).get()) != nullptr;
}

//! A best layout without a fault, as far as the search can tell.
LayoutSnapshot wholeLayout(SearchState& state) {
  FirstLayout(state).begin();
  LayoutSnapshot whole = state.ratedSnapshot();
  whole.tallies.collisions = whole.tallies.forbidden = whole.tallies.gaps = 0;
  whole.tallies.overfull = whole.tallies.failedConnections = 0;
  return whole;
}

TEST(FirstLayout, CoversEveryRunAndLeavesTheRestToRounds) {
  StateBench bench(testing::houseSketch());
  const Next next = FirstLayout(bench.state).begin();
  for (const layout::Cover& cover : bench.state.best().covers) {
    EXPECT_FALSE(cover.empty());
  }
  EXPECT_TRUE(leadsTo<Rounds>(next, bench.state));
}

TEST(FirstLayout, OffersWhatItLaidAsTheBest) {
  StateBench bench(testing::cubeSketch(4));
  FirstLayout(bench.state).begin();
  EXPECT_EQ(bench.state.best().covers, bench.state.snapshot().covers);
  EXPECT_EQ(bench.state.improvements(), 1U);
}

TEST(FromEarlier, LeavesTheFirstLayoutToOthersWhereThereIsNone) {
  StateBench bench(testing::cubeSketch(4));
  EXPECT_TRUE(leadsTo<FirstLayout>(FromEarlier(bench.state).begin(), bench.state));
  EXPECT_FALSE(bench.state.grown());
}

TEST(FromEarlier, EndsAtOnceWhereNothingWasTouchedAndAllIsWhole) {
  StateBench before(testing::squareSketch(8));
  const LayoutSnapshot laid = wholeLayout(before.state);
  ASSERT_EQ(before.state.layout().tallies().violations(), 0);
  AnnealingOptions options;
  options.earlier =
      earlierLayout(before.bench.problem.graph, before.bench.problem.sites, laid.covers);
  StateBench after(testing::squareSketch(8), options);
  const Next next = FromEarlier(after.state).begin();
  EXPECT_TRUE(std::holds_alternative<EndOfSearch>(next));
  EXPECT_EQ(after.state.best().covers, laid.covers);
}

TEST(FromEarlier, StartsOverWhereItsRoundDoesNotEndWhole) {
  StateBench bench(testing::squareSketch(8));
  LayoutSnapshot broken = wholeLayout(bench.state);
  broken.tallies.gaps = 1;
  bench.state.setBest(broken);
  EXPECT_TRUE(std::holds_alternative<StartOver>(FromEarlier(bench.state).endRound()));
}

TEST(Rounds, MakeTheFirstOneShorter) {
  StateBench bench(testing::gridSketch(4));
  FirstLayout(bench.state).begin();
  LayoutSnapshot broken = bench.state.best();
  broken.tallies.gaps = 1;
  bench.state.setBest(broken);
  Rounds rounds(bench.state);
  const Next first = rounds.begin();
  const Next second = rounds.endRound();
  EXPECT_LT(std::get<RoundPlan>(first).moves, std::get<RoundPlan>(second).moves);
}

TEST(Rounds, LeadToAxlesOnceALayoutIsWhole) {
  StateBench bench(testing::squareSketch(8));
  bench.state.setBest(wholeLayout(bench.state));
  EXPECT_TRUE(leadsTo<AxleTrials>(Rounds(bench.state).endRound(), bench.state));
}

TEST(Rounds, LeadToStiffeningWhereSomebodyMindsWhatIsLoose) {
  AnnealingOptions options;
  options.freedoms = [](const LayoutSnapshot&) { return 1; };
  StateBench bench(testing::squareSketch(8), options);
  bench.state.setBest(wholeLayout(bench.state));
  EXPECT_TRUE(leadsTo<Stiffening>(Rounds(bench.state).endRound(), bench.state));
}

TEST(Rounds, GiveUpAfterAsManyAsTheOptionsSay) {
  AnnealingOptions options;
  options.maxRounds = 2;
  StateBench bench(testing::squareSketch(8), options);
  LayoutSnapshot broken = wholeLayout(bench.state);
  broken.tallies.gaps = 1;
  bench.state.setBest(broken);
  Rounds rounds(bench.state);
  EXPECT_TRUE(std::holds_alternative<RoundPlan>(rounds.endRound()));
  EXPECT_TRUE(std::holds_alternative<RoundPlan>(rounds.endRound()));
  EXPECT_TRUE(leadsTo<AxleTrials>(rounds.endRound(), bench.state));
}

TEST(Stiffening, IsOverAtOnceWhereNothingIsLoose) {
  AnnealingOptions options;
  options.freedoms = [](const LayoutSnapshot&) { return 0; };
  StateBench bench(testing::squareSketch(8), options);
  bench.state.setBest(wholeLayout(bench.state));
  EXPECT_TRUE(leadsTo<AxleTrials>(Stiffening(bench.state).begin(), bench.state));
}

TEST(Stiffening, BeginsAtTheBestLayoutAndSaysHowLooseItIs) {
  AnnealingOptions options;
  options.freedoms = [](const LayoutSnapshot&) { return 3; };
  StateBench bench(testing::squareSketch(8), options);
  bench.state.setBest(wholeLayout(bench.state));
  const double before = bench.state.best().energy;
  Stiffening stiffening(bench.state);
  EXPECT_TRUE(std::holds_alternative<RoundPlan>(stiffening.begin()));
  EXPECT_TRUE(stiffening.habits().stiffening);
  EXPECT_EQ(bench.state.best().freedoms, 3);
  EXPECT_GT(bench.state.best().energy, before);
}

TEST(Stiffening, TriesAnotherStartWhereOneStaysLoose) {
  AnnealingOptions options;
  options.freedoms = [](const LayoutSnapshot&) { return 3; };
  options.stiffening.roundsPerStart = 1;
  StateBench bench(testing::squareSketch(8), options);
  bench.state.setBest(wholeLayout(bench.state));
  Stiffening stiffening(bench.state);
  stiffening.begin();
  EXPECT_TRUE(std::holds_alternative<RoundPlan>(stiffening.endRound()));
  EXPECT_FALSE(stiffening.habits().stiffening);
}

TEST(AxleTrials, TryNothingOnALayoutWithFaults) {
  StateBench bench(testing::squareSketch(8));
  LayoutSnapshot broken = wholeLayout(bench.state);
  broken.tallies.gaps = 1;
  bench.state.setBest(broken);
  EXPECT_TRUE(leadsTo<FurtherHolds>(AxleTrials(bench.state).begin(), bench.state));
}

TEST(AxleTrials, TryNothingWhereNoAxlesAreAllowed) {
  AnnealingOptions options;
  options.axles.clear();
  StateBench bench(testing::gridSketch(3), options);
  bench.state.setBest(wholeLayout(bench.state));
  EXPECT_TRUE(leadsTo<FurtherHolds>(AxleTrials(bench.state).begin(), bench.state));
}

TEST(FurtherHolds, AddNothingWhereNobodyMindsWhatMoves) {
  StateBench bench(testing::squareSketch(8));
  bench.state.setBest(wholeLayout(bench.state));
  const LayoutSnapshot before = bench.state.best();
  EXPECT_TRUE(std::holds_alternative<EndOfSearch>(FurtherHolds(bench.state).begin()));
  EXPECT_EQ(bench.state.best().tallies.connectors, before.tallies.connectors);
}

//! A state in which each beam is a body of its own, and any further mechanism holds all.
struct HoldsBench : StateBench {
  explicit HoldsBench(bool buildable) : StateBench(testing::cubeSketch(7), optionsOf(buildable)) {
    state.setBest(wholeLayout(state));
    mechanisms = state.best().tallies.mechanisms;
  }

  AnnealingOptions optionsOf(bool buildable) {
    AnnealingOptions options;
    options.freedoms = [this](const LayoutSnapshot& layout) {
      int there = 0;
      for (const layout::JunctionState& junction : layout.junctions) {
        there += static_cast<int>(junction.connection.mechanisms.size());
      }
      return mechanisms < 0 || there > mechanisms ? 0 : 1;
    };
    options.bodies = [this] {
      std::vector<std::vector<int>> bodies;
      for (const layout::Cover& cover : state.best().covers) {
        for (bodies.emplace_back(); bodies.back().size() < cover.beams.size();) {
          bodies.back().push_back(next++);
        }
      }
      return bodies;
    };
    options.buildable = [buildable](const LayoutSnapshot&) { return buildable; };
    return options;
  }

  int mechanisms = -1;
  int next = 0;
};

TEST(FurtherHolds, AddAMechanismThatHoldsWhatMoves) {
  HoldsBench bench(true);
  FurtherHolds(bench.state).begin();
  EXPECT_EQ(bench.state.best().tallies.mechanisms, bench.mechanisms + 1);
  EXPECT_EQ(bench.state.best().freedoms, 0);
}

TEST(FurtherHolds, AddNoneThatCannotBeBuilt) {
  HoldsBench bench(false);
  FurtherHolds(bench.state).begin();
  EXPECT_EQ(bench.state.best().tallies.mechanisms, bench.mechanisms);
}

TEST(SearchState, StartsOverAsItBegan) {
  StateBench bench(testing::houseSketch());
  FirstLayout(bench.state).begin();
  const LayoutSnapshot first = bench.state.best();
  bench.state.raiseGrudges();
  bench.state.clock().countMove();
  bench.state.startOver();
  EXPECT_EQ(bench.state.clock().moves(), 0U);
  EXPECT_EQ(bench.state.clock().allMoves(), 1U);
  FirstLayout(bench.state).begin();
  EXPECT_EQ(bench.state.best().covers, first.covers);
}

TEST(MoveClock, CoolsFromTheStartOfARoundToTheEnd) {
  MoveClock clock(0.25);
  clock.beginRound({100, 6.0});
  clock.cool();
  EXPECT_DOUBLE_EQ(clock.temperature(), 6.0);
  for (int i = 0; i < 100; ++i) {
    EXPECT_FALSE(clock.roundIsOver());
    clock.countMove();
  }
  EXPECT_TRUE(clock.roundIsOver());
  clock.cool();
  EXPECT_NEAR(clock.temperature(), 0.25, 1e-9);
}

TEST(MoveClock, IsStuckAfterManyMovesWithoutProgress) {
  MoveClock clock(0.25);
  clock.beginRound({1000, 6.0});
  for (std::uint64_t i = 0; i <= kTuning.rounds.patience; ++i) {
    EXPECT_FALSE(clock.isStuck());
    clock.countMove();
  }
  EXPECT_TRUE(clock.isStuck());
  clock.noteProgress();
  EXPECT_FALSE(clock.isStuck());
}

}  // namespace
}  // namespace liftarm::search
