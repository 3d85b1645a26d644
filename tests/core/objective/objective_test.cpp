#include "objective/objective.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/helpers/sketches.h"

namespace liftarm::objective {
namespace {

constexpr std::array<Preset, 4> kPresets{
    Preset::kFaithful, Preset::kSimple, Preset::kFaithfulRigid, Preset::kSimpleRigid};

double weight(const Weights& weights, std::string_view term) {
  return weights[*termIndex(term)];
}

Measures some(int salt) {
  Measures m;
  m.tallies.beams = 10 + salt;
  m.tallies.holes = 70 + 3 * salt;
  m.tallies.layerSquares = 5 * salt;
  m.tallies.gaps = salt;
  m.tallies.mechanisms = 4;
  m.tallies.pinHeadRatios = 3.0;
  m.tallies.connectionCost = 20.0 + salt;
  m.scale = {90.0, 100.0, 40.0};
  m.componentRange = salt;
  return m;
}

TEST(Objective, IsTheWeightedSumOfItsTerms) {
  for (const Preset preset : kPresets) {
    const Weights weights = paperWeights(preset);
    double sum = 0.0;
    for (std::size_t i = 0; i < kTerms.size(); ++i) {
      sum += weights[i] * kTerms[i].value(some(2));
    }
    EXPECT_DOUBLE_EQ(value(some(2), weights), sum);
  }
}

TEST(Objective, DeltaIsTheDifferenceOfValues) {
  for (const Preset preset : kPresets) {
    for (const Weights& weights : {searchWeights(preset), paperWeights(preset)}) {
      EXPECT_DOUBLE_EQ(delta(some(1), some(3), weights),
                       value(some(3), weights) - value(some(1), weights));
    }
  }
}

TEST(Objective, DeltaThereAndBackIsZero) {
  const Weights weights = searchWeights(Preset::kSimple);
  EXPECT_NEAR(delta(some(1), some(3), weights) + delta(some(3), some(1), weights), 0.0, 1e-9);
}

TEST(Objective, OfAnEmptyLayoutIsFinite) {
  for (const Preset preset : kPresets) {
    EXPECT_TRUE(std::isfinite(value(Measures{}, searchWeights(preset))));
    EXPECT_TRUE(std::isfinite(value(Measures{}, paperWeights(preset))));
  }
}

TEST(Objective, KnowsEveryPresetByItsName) {
  for (const Preset preset : kPresets) {
    EXPECT_EQ(presetFromName(nameOf(preset)), preset);
  }
  EXPECT_EQ(presetFromName("simple-rigid"), Preset::kSimpleRigid);
  EXPECT_EQ(presetFromName("Simple"), std::nullopt);
  EXPECT_EQ(presetFromName(""), std::nullopt);
}

TEST(Objective, KnowsNoTermByAWrongName) {
  EXPECT_EQ(termIndex("nothing"), std::nullopt);
}

TEST(Objective, HasThePapersFixedWeights) {
  for (const Preset preset : kPresets) {
    const Weights weights = paperWeights(preset);
    EXPECT_EQ(weight(weights, "cpt"), 1.0);
    EXPECT_EQ(weight(weights, "sym"), 30.0);
    EXPECT_EQ(weight(weights, "phr"), 10.0);
    EXPECT_EQ(weight(weights, "col"), 30.0);
    EXPECT_EQ(weight(weights, "gap"), 100.0);
    EXPECT_EQ(weight(weights, "coh"), 50.0);
  }
}

struct UserWeights {
  Preset preset;
  double dev;
  double tbl;
  double rgd;
};

struct PaperPreset : ::testing::TestWithParam<UserWeights> {};

TEST_P(PaperPreset, HasThePapersUserWeights) {
  const Weights weights = paperWeights(GetParam().preset);
  EXPECT_EQ(weight(weights, "dev"), GetParam().dev);
  EXPECT_EQ(weight(weights, "tbl"), GetParam().tbl);
  EXPECT_EQ(weight(weights, "rgd"), GetParam().rgd);
}

INSTANTIATE_TEST_SUITE_P(All,
                         PaperPreset,
                         ::testing::Values(UserWeights{Preset::kFaithful, 100, 0, 0},
                                           UserWeights{Preset::kSimple, 0, 100, 0},
                                           UserWeights{Preset::kFaithfulRigid, 100, 0, 100},
                                           UserWeights{Preset::kSimpleRigid, 0, 100, 100}));

TEST(Objective, GivesThePapersWeightsToItsTermsOnly) {
  for (const Preset preset : kPresets) {
    const Weights weights = paperWeights(preset);
    for (const char* term :
         {"beams", "holes", "layers", "overhang", "hinges", "connections", "violations"}) {
      EXPECT_EQ(weight(weights, term), 0.0) << term;
    }
  }
}

TEST(Objective, NeverPaysForAViolationWithABeam) {
  // One violation costs more than the beam and the pins that would mend it.
  for (const Preset preset : kPresets) {
    const Weights weights = searchWeights(preset);
    EXPECT_GT(weight(weights, "violations"),
              weight(weights, "beams") + 2.0 * weight(weights, "connections"));
  }
}

TEST(Objective, ScaleCountsNodesEdgesAndBranching) {
  // A square of 8: 32 nodes of degree 2, 32 edges.
  const Scale scale = scaleOf(testing::graphOf(testing::squareSketch(8)));
  EXPECT_EQ(scale.nodes, 32.0);
  EXPECT_EQ(scale.edges, 32.0);
  EXPECT_EQ(scale.branching, 32.0);
}

TEST(Objective, ScaleOfAnEmptyGraphDividesByNoZero) {
  const Scale scale = scaleOf({});
  EXPECT_EQ(scale.nodes, 1.0);
  EXPECT_EQ(scale.edges, 1.0);
  EXPECT_EQ(scale.branching, 1.0);
}

}  // namespace
}  // namespace liftarm::objective
