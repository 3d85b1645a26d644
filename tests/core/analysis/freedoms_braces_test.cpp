#include "analysis/freedoms_braces.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/motion.h"
#include "core/helpers/models.h"

namespace liftarm::analysis {
namespace {

std::vector<Brace> bracesOf(const model::Model& model) {
  const Scene scene = makeScene(model, parts::Catalogue::builtIn());
  return analyseMotion(scene, findCoverage(scene)).braces;
}

TEST(Braces, SquareNeedsOne) {
  EXPECT_EQ(bracesOf(testing::squareFrame()).size(), 1U);
}

TEST(Braces, HaveWholeLengths) {
  for (const Brace& brace : bracesOf(testing::squareFrame())) {
    const double length = lattice::length(brace.to - brace.from);
    EXPECT_NEAR(length, std::round(length), 1e-9);
  }
}

TEST(Braces, JoinTwoLinesThatTheyStartAndEndOn) {
  const std::vector<Brace> braces = bracesOf(testing::squareFrame());
  ASSERT_EQ(braces.size(), 1U);
  ASSERT_EQ(braces[0].lines.size(), 2U);
  EXPECT_NE(braces[0].lines[0], braces[0].lines[1]);
}

TEST(Braces, AreNotAlongALatticeAxisOfTheSquare) {
  // A bar parallel to a side of the square would swing with it.
  const std::vector<Brace> braces = bracesOf(testing::squareFrame());
  ASSERT_EQ(braces.size(), 1U);
  const lattice::Vec3 way = braces[0].to - braces[0].from;
  EXPECT_GT(std::abs(way.x), 0.5);
  EXPECT_GT(std::abs(way.y), 0.5);
}

TEST(Braces, RigidTriangleNeedsNone) {
  EXPECT_TRUE(bracesOf(testing::pythagoreanTriangle()).empty());
}

}  // namespace
}  // namespace liftarm::analysis
