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
