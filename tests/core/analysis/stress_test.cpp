// Whole models: what stands, what moves, and that the ground carries it.

#include "analysis/stress.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/freedoms.h"
#include "analysis/freedoms_query.h"
#include "core/helpers/models.h"
#include "core/helpers/solved.h"

namespace liftarm::analysis {
namespace {

using lattice::Vec3;
using ::testing::Contains;
using ::testing::HasSubstr;
using testing::kX;
using testing::kY;
using testing::kZ;

StressState solvedState(const model::Model& model, const StressOptions& options = {}) {
  const Scene scene = makeScene(model, parts::Catalogue::builtIn());
  base::Result<StressState> state = solveStress(scene, options);
  if (!state.ok()) {
    ADD_FAILURE() << state.error().message;
    return {};
  }
  return std::move(state).value();
}

StressReport reported(const model::Model& model, const StressOptions& options = {}) {
  const Scene scene = makeScene(model, parts::Catalogue::builtIn());
  const StressState state = solvedState(model, options);
  if (!state.stands) {
    ADD_FAILURE() << model.name << ": " << state.message;
    return {};
  }
  return reportStress(scene, state);
}

StressOptions withFriction(FitHold friction) {
  StressOptions options;
  options.friction = friction;
  return options;
}

//! Sum of forces and of moments about the origin, over loads and reactions, N and N mm.
std::pair<Vec3, Vec3> unbalanced(const model::Model& model, const StressState& state) {
  const Scene scene = makeScene(model, parts::Catalogue::builtIn());
  Vec3 force;
  Vec3 moment;
  const std::vector<Six> loads = nodalLoads(state.model.frame);
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const Vec3 f{loads[i][0], loads[i][1], loads[i][2]};
    const Vec3 m{loads[i][3], loads[i][4], loads[i][5]};
    force = force + f;
    moment = moment + m + lattice::cross(state.model.frame.nodes[i], f);
  }
  for (const Reaction& reaction : reportStress(scene, state).reactions) {
    force = force + reaction.force;
    moment = moment + lattice::cross(kMillimetresPerModule * reaction.at, reaction.force);
  }
  return {force, moment};
}

TEST(Square, OfFreePinsIsRefusedWithThePartsThatMove) {
  const StressState state = solvedState(testing::squareFrame(), withFriction(FitHold::kFree));
  EXPECT_FALSE(state.stands);
  EXPECT_THAT(state.message, HasSubstr("40490"));
  EXPECT_THAT(state.message, HasSubstr("friction"));
  EXPECT_THAT(state.moving, Contains(2));
}

TEST(Square, OfHeldPinsStands) {
  const StressReport report = reported(testing::squareFrame());
  EXPECT_GT(report.maxStress, 0.0);
  EXPECT_LT(report.maxDisplacement, 0.1);
}

TEST(Triangle, StandsWithoutFriction) {
  EXPECT_GT(reported(testing::pythagoreanTriangle(), withFriction(FitHold::kFree)).safety, 1.0);
}

TEST(Square, IsStressedAlikeOnBothSides) {
  const StressReport report = reported(testing::squareFrame());
  EXPECT_NEAR(report.parts[2].stress, report.parts[3].stress, 1e-6 * report.parts[2].stress);
  EXPECT_NEAR(report.parts[0].stress, report.parts[1].stress, 1e-6 * report.parts[2].stress);
}

TEST(Reactions, CarryTheWeightOfEveryPart) {
  const model::Model model = testing::squareFrame();
  double grams = 0.0;
  for (const model::PlacedPart& part : model.parts) {
    grams += parts::Catalogue::builtIn().find(part.part)->mass;
  }
  const StressReport report = reported(model);
  double carried = 0.0;
  for (const Reaction& reaction : report.reactions) {
    carried += reaction.force.z;
    EXPECT_GE(reaction.force.z, -1e-9) << "the ground does not pull";
  }
  EXPECT_NEAR(carried, grams / 1000.0 * kGravity, 1e-6 * carried);
  EXPECT_NEAR(report.weight, carried, 1e-6 * carried);
}

struct Example : ::testing::TestWithParam<const char*> {};

TEST_P(Example, IsInEquilibrium) {
  const model::Model model = testing::solvedExample(GetParam());
  StressOptions options;
  options.loads.push_back({testing::middlePart(model), {0.002, -0.003, -0.5}});
  for (const StressOptions& each : {StressOptions(), options}) {
    const StressState state = solvedState(model, each);
    ASSERT_TRUE(state.stands) << state.message;
    const auto [force, moment] = unbalanced(model, state);
    const double size = state.model.weight + 1.0;
    EXPECT_LT(lattice::length(force), 1e-6 * size);
    EXPECT_LT(lattice::length(moment), 1e-6 * size * 100.0);
  }
}

TEST_P(Example, IsFarFromBreakingUnderItsOwnWeight) {
  const StressReport report = reported(testing::solvedExample(GetParam()));
  EXPECT_GT(report.safety, 5.0);
  EXPECT_LT(report.maxDisplacement, 5.0);
}

INSTANTIATE_TEST_SUITE_P(Some, Example, ::testing::Values("cube", "table", "bridge", "tower"));

TEST(Loads, AreCarriedByTheGround) {
  StressOptions options;
  options.loads.push_back({{4, 0, 0.5}, {0, 0, -5.0}});
  const StressReport report = reported(testing::squareFrame(), options);
  double carried = 0.0;
  for (const Reaction& reaction : report.reactions) {
    carried += reaction.force.z;
  }
  EXPECT_NEAR(carried, report.weight + 5.0, 1e-6 * carried);
}

TEST(Loads, StressThePartThatTheyActOn) {
  StressOptions options;
  options.loads.push_back({{0, 4, 1}, {0, 0, -5.0}});
  const StressReport report = reported(testing::squareFrame(), options);
  EXPECT_GT(report.parts[2].stress, 5 * report.parts[3].stress);
}

//! A beam over two others: simply supported over 12 modules, loaded in the middle.
model::Model bridge() {
  model::Model model;
  model.name = "Bridge";
  model.parts = {testing::beamAt("40490", {0, 0, 0}, kY, kZ),
                 testing::beamAt("40490", {12, 0, 0}, kY, kZ),
                 testing::beamAt("32278", {6, 0, 1}, kX, kZ),
                 testing::pinAt("2780", {0, 0, 0.5}, kZ),
                 testing::pinAt("2780", {12, 0, 0.5}, kZ)};
  return model;
}

TEST(Bridge, SagsBetweenTheClampedAndTheSimplySupportedBeam) {
  StressOptions options;
  constexpr double kForce = 10.0;
  options.loads.push_back({{6, 0, 1}, {0, 0, -kForce}});
  const StressReport loaded = reported(bridge(), options);
  const StressReport light = reported(bridge());
  const auto sag = [](const StressReport& report) {
    double most = 0.0;
    for (const StressSample& sample : report.parts[2].samples) {
      most = std::max(most, -sample.displacement.z);
    }
    return most;
  };
  const Section s = beamSection(kBeamWidth, kBeamDepth);
  const double span = 12 * kMillimetresPerModule;
  const double shear = kForce * span / (4 * kAbs.shearModulus() * s.shearZ);
  const double bending = kForce * span * span * span / (48 * kAbs.youngsModulus * s.inertiaY);
  const double found = sag(loaded) - sag(light);
  EXPECT_GT(found, bending / 4 + shear);
  EXPECT_LT(found, 1.1 * (bending + shear));
}

TEST(Bridge, ShearsItsPinsByHalfASidewaysLoad) {
  StressOptions options;
  // Along the beam, and down, so that nothing tips.
  options.loads.push_back({{6, 0, 1}, {4.0, 0, -20.0}});
  const StressReport report = reported(bridge(), options);
  ASSERT_EQ(report.pins.size(), 2U);
  // One foot keeps the model from sliding, so one pin may carry all of it.
  const double most = std::max(report.pins[0].shear, report.pins[1].shear);
  EXPECT_GT(most, 2.0 / pinSection().netShear);
  EXPECT_LT(most, 4.5 / pinSection().netShear);
}

TEST(Loads, InTheAirAreRefused) {
  StressOptions options;
  options.loads.push_back({{4, 4, 20}, {0, 0, -5.0}});
  const model::Model model = testing::squareFrame();
  const Scene scene = makeScene(model, parts::Catalogue::builtIn());
  const base::Result<StressState> state = solveStress(scene, options);
  ASSERT_FALSE(state.ok());
  EXPECT_THAT(state.error().message, HasSubstr("loads[0].at"));
}

TEST(Loads, ThatLiftTheModelAreRefused) {
  StressOptions options;
  options.loads.push_back({{0, 0, 0}, {0, 0, 5.0}});
  const StressState state = solvedState(testing::squareFrame(), options);
  EXPECT_FALSE(state.stands);
  EXPECT_THAT(state.message, HasSubstr("tips"));
}

TEST(Model, WithoutPartsIsRefused) {
  const model::Model model;
  const Scene scene = makeScene(model, parts::Catalogue::builtIn());
  const base::Result<StressState> state = solveStress(scene, {});
  ASSERT_FALSE(state.ok());
  EXPECT_THAT(state.error().message, HasSubstr("no parts"));
}

TEST(Model, WithAnUnknownPartIsRefusedByItsName) {
  model::Model model = testing::squareFrame();
  model.parts[3].part = "nothing";
  const Scene scene = makeScene(model, parts::Catalogue::builtIn());
  const base::Result<StressState> state = solveStress(scene, {});
  ASSERT_FALSE(state.ok());
  EXPECT_THAT(state.error().message, HasSubstr("part 3 (nothing"));
}

TEST(Model, WithALooseBeamAboveTheGroundIsRefused) {
  model::Model model = testing::squareFrame();
  model.parts.push_back(testing::beamAt("32316", {4, 4, 9}, kX, kZ));
  const StressState state = solvedState(model);
  EXPECT_FALSE(state.stands);
  EXPECT_THAT(state.moving, Contains(8));
}

TEST(Model, WithAnAxleThatOnlySpinsStandsWithoutFriction) {
  model::Model model = testing::pythagoreanTriangle();
  // Through two holes of the upright beam.
  model.parts.push_back(testing::pinAt("4519", {0, 1, 4}, kY));
  EXPECT_TRUE(solvedState(model, withFriction(FitHold::kFree)).stands);
}

TEST(Model, FoldsWhereItHasAFreedomAndNowhereElse) {
  std::vector<model::Model> models = testing::buildableModels();
  models.push_back(testing::squareFrame());
  for (std::size_t pin = 4; pin < 8; ++pin) {
    models.back().parts[pin].part = "3673";
  }
  int refused = 0;
  for (const model::Model& model : models) {
    const Scene scene = makeScene(model, parts::Catalogue::builtIn());
    for (const auto& [hold, friction] :
         {std::pair(FitHold::kFree, Friction::kFree), std::pair(FitHold::kHeld, Friction::kHeld)}) {
      const FreedomsQuery query = makeFreedomsQuery(scene, findCoverage(scene), friction);
      const bool rigid = findFreedoms(query).internal == 0;
      const StressState state = solvedState(model, withFriction(hold));
      const bool tips = state.message.find("tips over") != std::string::npos;
      EXPECT_EQ(state.stands || tips, rigid) << model.name << ": " << state.message;
      refused += rigid ? 0 : 1;
    }
  }
  EXPECT_GT(refused, 2);
}

TEST(Locked, HoldsPinsWithoutFriction) {
  model::Model model = testing::squareFrame();
  for (std::size_t pin = 4; pin < 8; ++pin) {
    model.parts[pin].part = "3673";
  }
  EXPECT_FALSE(solvedState(model, withFriction(FitHold::kHeld)).stands);
  EXPECT_TRUE(solvedState(model, withFriction(FitHold::kLocked)).stands);
}

TEST(Held, SofterFrictionGivesWayMore) {
  model::Model model = testing::squareFrame();
  StressOptions options;
  options.loads.push_back({{8, 8, 0}, {0.05, 0, -1.0}});
  const double stiff = reported(model, options).maxDisplacement;
  options.heldStiffness = kHeldStiffness / 10;
  EXPECT_GT(reported(model, options).maxDisplacement, 2 * stiff);
}

}  // namespace
}  // namespace liftarm::analysis
