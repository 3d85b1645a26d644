#include <cmath>
#include <functional>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "objective/objective.h"
#include "objective/term.h"

namespace liftarm::objective {
namespace {

//! Hand-made numbers, each different, so that no term can take another's.
Measures sample() {
  Measures m;
  m.tallies.beams = 12;
  m.tallies.holes = 80;
  m.tallies.layerSquares = 20;
  m.tallies.overhang = 3;
  m.tallies.hinges = 5;
  m.tallies.collisions = 4;
  m.tallies.forbidden = 2;
  m.tallies.gaps = 6;
  m.tallies.overfull = 1;
  m.tallies.failedConnections = 7;
  m.tallies.connectors = 30;
  m.tallies.mechanisms = 10;
  m.tallies.pinHeadRatios = 8.5;
  m.tallies.connectionCost = 33.25;
  m.scale = {100.0, 140.0, 50.0};
  m.componentRange = 3;
  m.symmetryDeviation = 0.75;
  m.rigidSubsets = 9;
  return m;
}

double termValue(std::string_view name, const Measures& m) {
  return kTerms[*termIndex(name)].value(m);
}

struct Expected {
  const char* term;
  double value;
};

struct TermValue : ::testing::TestWithParam<Expected> {};

TEST_P(TermValue, IsWhatItsFormulaSays) {
  EXPECT_DOUBLE_EQ(termValue(GetParam().term, sample()), GetParam().value);
}

INSTANTIATE_TEST_SUITE_P(Terms,
                         TermValue,
                         ::testing::Values(Expected{"dev", 0.5},
                                           Expected{"cpt", 9.0},
                                           Expected{"sym", 0.75},
                                           Expected{"tbl", 0.8},
                                           Expected{"phr", 0.15},
                                           Expected{"col", 0.05},
                                           Expected{"gap", 0.06},
                                           Expected{"coh", 0.05},
                                           Expected{"rgd", 0.18},
                                           Expected{"beams", 12.0},
                                           Expected{"holes", 80.0},
                                           Expected{"layers", 20.0},
                                           Expected{"overhang", 3.0},
                                           Expected{"hinges", 5.0},
                                           Expected{"connections", 33.25},
                                           Expected{"violations", 20.0}),
                         [](const auto& row) { return std::string(row.param.term); });

TEST(Terms, HaveDifferentNames) {
  std::set<std::string_view> names;
  for (const Term& term : kTerms) {
    EXPECT_TRUE(names.insert(term.name).second) << term.name;
  }
}

TEST(Terms, AreFiniteForAnEmptyLayout) {
  for (const Term& term : kTerms) {
    EXPECT_TRUE(std::isfinite(term.value(Measures{}))) << term.name;
  }
}

TEST(Terms, AreZeroForAnEmptyLayout) {
  for (const Term& term : kTerms) {
    EXPECT_EQ(term.value(Measures{}), 0.0) << term.name;
  }
}

TEST(Terms, DoNotRewardLeavingBeamsUnjoined) {
  // With no connection the ratio counts as perfect: no layout has a better one.
  Measures none = sample();
  none.tallies.mechanisms = 0;
  none.tallies.pinHeadRatios = 0.0;
  EXPECT_EQ(termValue("phr", none), 0.0);
  EXPECT_GT(termValue("coh", sample()), 0.0);
}

struct Worse {
  const char* name;
  std::function<void(Measures*)> spoil;
  const char* term;
};

TEST(Terms, GrowWithWhatTheyMeasure) {
  const std::vector<Worse> cases{
      {"layers", [](Measures* m) { ++m->tallies.layerSquares; }, "dev"},
      {"range", [](Measures* m) { ++m->componentRange; }, "cpt"},
      {"holes", [](Measures* m) { ++m->tallies.holes; }, "tbl"},
      {"ratio", [](Measures* m) { m->tallies.pinHeadRatios -= 1.0; }, "phr"},
      {"collision", [](Measures* m) { ++m->tallies.collisions; }, "col"},
      {"gap", [](Measures* m) { ++m->tallies.gaps; }, "gap"},
      {"failure", [](Measures* m) { ++m->tallies.failedConnections; }, "coh"},
      {"subset", [](Measures* m) { ++m->rigidSubsets; }, "rgd"},
      {"collision", [](Measures* m) { ++m->tallies.collisions; }, "violations"},
      {"forbidden", [](Measures* m) { ++m->tallies.forbidden; }, "violations"},
      {"gap", [](Measures* m) { ++m->tallies.gaps; }, "violations"},
      {"overfull", [](Measures* m) { ++m->tallies.overfull; }, "violations"},
      {"failure", [](Measures* m) { ++m->tallies.failedConnections; }, "violations"}};
  for (const Worse& worse : cases) {
    Measures m = sample();
    worse.spoil(&m);
    EXPECT_GT(termValue(worse.term, m), termValue(worse.term, sample()))
        << worse.term << " with one more " << worse.name;
  }
}

}  // namespace
}  // namespace liftarm::objective
