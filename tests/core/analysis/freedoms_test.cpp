#include "analysis/freedoms.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/freedoms_query.h"
#include "core/analysis/linkages.h"
#include "core/helpers/models.h"

namespace liftarm::analysis {
namespace {

using testing::Mechanism;

struct KnownMechanism : ::testing::TestWithParam<Mechanism> {};

Freedoms freedomsOf(const model::Model& model, Friction friction) {
  const Scene scene = makeScene(model, parts::Catalogue::builtIn());
  return findFreedoms(makeFreedomsQuery(scene, findCoverage(scene), friction));
}

TEST_P(KnownMechanism, HasTheFreedomsOfTheTextbook) {
  const Freedoms freedoms = findFreedoms(testing::queryOf(GetParam().linkage));
  EXPECT_EQ(freedoms.internal, GetParam().freedoms);
}

TEST_P(KnownMechanism, IsCountedAlikeWithoutItsMotions) {
  const FreedomsQuery query = testing::queryOf(GetParam().linkage);
  EXPECT_EQ(countFreedomsBeyondJoints(query), findFreedoms(query).beyondJoints);
}

TEST_P(KnownMechanism, HasTheFreedomsOfADenseDecomposition) {
  const Freedoms freedoms = findFreedoms(testing::queryOf(GetParam().linkage));
  EXPECT_EQ(freedoms.internal + freedoms.spinning,
            testing::nullityByReflections(GetParam().linkage));
}

TEST_P(KnownMechanism, KeepsItsMotionsWithinTheConstraints) {
  const Freedoms freedoms = findFreedoms(testing::queryOf(GetParam().linkage));
  ASSERT_EQ(static_cast<int>(freedoms.motions.size()), freedoms.internal);
  for (const FreeMotion& motion : freedoms.motions) {
    EXPECT_LT(testing::violation(GetParam().linkage, motion.twists), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(All,
                         KnownMechanism,
                         ::testing::ValuesIn(testing::knownMechanisms()),
                         [](const auto& test) { return test.param.name; });

//! Two beams on the first axle of frameOfAxles() alone.
model::Model beamsOnOneAxle(const std::string& joint) {
  model::Model model = testing::frameOfAxles();
  model.parts.resize(7);
  model.sketchJson =
      testing::sketchOf({{{0, 0, 0}, {4, 0, 0}}, {{0, 4, 0}, {4, 4, 0}}, {{0, 0, 0}, {0, 4, 0}}},
                        R"(,"joints":[)" + joint + "]");
  return model;
}

TEST(Freedoms, AJointAboutALineTurnsOnTheAxleThatStandsForIt) {
  const Freedoms freedoms = freedomsOf(
      beamsOnOneAxle(R"({"at":[0,0,0],"axis":[0,1,0],"between":[[2],[0]]})"), Friction::kHeld);
  ASSERT_EQ(freedoms.jointTurns.size(), 1U);
  EXPECT_TRUE(freedoms.jointTurns.front());
  EXPECT_EQ(freedoms.internal, 1);
  EXPECT_EQ(freedoms.beyondJoints, 0);
}

TEST(Freedoms, AnAxleAloneIsOneSideOfAJoint) {
  model::Model model = beamsOnOneAxle(R"({"at":[0,0,0],"axis":[0,1,0],"between":[[1],[0]]})");
  model.parts.erase(model.parts.begin() + 1);
  model.parts[4] = testing::partAt("3713", {0, 2, 0});
  model.parts.pop_back();
  model.sketchJson =
      testing::sketchOf({{{0, 0, 0}, {4, 0, 0}}, {{0, 0, 0}, {0, 4, 0}}},
                        R"(,"joints":[{"at":[0,0,0],"axis":[0,1,0],"between":[[1],[0]]}])");
  const Freedoms freedoms = freedomsOf(model, Friction::kHeld);
  ASSERT_EQ(freedoms.jointTurns.size(), 1U);
  EXPECT_TRUE(freedoms.jointTurns.front());
  EXPECT_EQ(freedoms.beyondJoints, 0);
}

struct RealModel : ::testing::TestWithParam<model::Model> {};

TEST_P(RealModel, HasTheFreedomsOfADenseDecomposition) {
  const Scene scene = makeScene(GetParam(), parts::Catalogue::builtIn());
  for (const Friction friction : {Friction::kFree, Friction::kHeld}) {
    const FreedomsQuery query = makeFreedomsQuery(scene, findCoverage(scene), friction);
    const Freedoms freedoms = findFreedoms(query);
    EXPECT_EQ(freedoms.internal + freedoms.spinning, testing::nullityByReflections(query.linkage));
  }
}

TEST_P(RealModel, IsCountedAlikeWithoutItsMotions) {
  const Scene scene = makeScene(GetParam(), parts::Catalogue::builtIn());
  for (const Friction friction : {Friction::kFree, Friction::kHeld}) {
    const FreedomsQuery query = makeFreedomsQuery(scene, findCoverage(scene), friction);
    EXPECT_EQ(countFreedomsBeyondJoints(query), findFreedoms(query).beyondJoints);
  }
}

TEST_P(RealModel, KeepsItsMotionsWithinTheConstraints) {
  const Scene scene = makeScene(GetParam(), parts::Catalogue::builtIn());
  const FreedomsQuery query = makeFreedomsQuery(scene, findCoverage(scene), Friction::kFree);
  for (const FreeMotion& motion : findFreedoms(query).motions) {
    EXPECT_LT(testing::violation(query.linkage, motion.twists), 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(All, RealModel, ::testing::ValuesIn(testing::buildableModels()));

TEST(Freedoms, SquareOfSinglePinsFolds) {
  EXPECT_EQ(freedomsOf(testing::squareFrame(), Friction::kFree).internal, 1);
}

TEST(Freedoms, FrictionHoldsTheSquare) {
  EXPECT_EQ(freedomsOf(testing::squareFrame(), Friction::kHeld).internal, 0);
}

//! What the fits of a model let go of, each expected to be the same.
void expectPlay(const model::Model& model, Friction friction, Play expected) {
  const Scene scene = makeScene(model, parts::Catalogue::builtIn());
  int fits = 0;
  for (const model::Connection& c : scene.connections) {
    const Play play = playOf(scene, c, friction);
    EXPECT_EQ(play.turns, expected.turns);
    EXPECT_EQ(play.shifts, expected.shifts);
    ++fits;
  }
  EXPECT_GT(fits, 1);
}

model::Model squareOn(const char* pin) {
  model::Model model = testing::squareFrame();
  for (std::size_t i = 4; i < 8; ++i) {
    model.parts[i].part = pin;
  }
  return model;
}

TEST(Friction, HoldsPinsWithRidgesAndThoseOfConnectors) {
  for (const model::Model& model : {squareOn("2780"), testing::cornerOfTwoBeams()}) {
    expectPlay(model, Friction::kFree, {true, false});
    expectPlay(model, Friction::kHeld, {false, false});
  }
}

TEST(Friction, LetsPlainPinsTurn) {
  expectPlay(squareOn("3673"), Friction::kHeld, {true, false});
}

TEST(Friction, KeepsAxlesFromSlidingButNotFromTurning) {
  expectPlay(squareOn("3704"), Friction::kFree, {true, true});
  expectPlay(squareOn("3704"), Friction::kHeld, {true, false});
}

TEST(Freedoms, PinsThatSpinAreToldApart) {
  const Freedoms freedoms = freedomsOf(testing::squareFrame(), Friction::kFree);
  EXPECT_EQ(freedoms.spinning, 4);
}

TEST(Freedoms, OppositeBeamsOfASquareAreDifferentGroups) {
  const Freedoms freedoms = freedomsOf(testing::squareFrame(), Friction::kFree);
  EXPECT_NE(freedoms.groupOf[0], freedoms.groupOf[2]);
  EXPECT_NE(freedoms.groupOf[0], freedoms.groupOf[1]);
}

}  // namespace
}  // namespace liftarm::analysis
