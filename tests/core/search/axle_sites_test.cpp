#include "search/axle_sites.h"

#include <gtest/gtest.h>

#include "core/helpers/layouts.h"

namespace liftarm::search {
namespace {

constexpr int kLongest = 12;

//! Runs 0 and 1 along x, run 2 between them along y.
sketch::Sketch bridgeSketch(double length = 4) {
  return testing::sketchFrom(
      {{{0, 0, 0}, {8, 0, 0}}, {{0, length, 0}, {8, length, 0}}, {{4, 0, 0}, {4, length, 0}}});
}

bool mayHave(const sketch::Sketch& sketch, int run = 2) {
  return mayHaveAxle(testing::graphOf(sketch), run, kLongest);
}

TEST(AxleSites, ALineBetweenOthersMayHaveAnAxle) {
  EXPECT_TRUE(mayHave(bridgeSketch()));
  EXPECT_FALSE(needsAxle(testing::graphOf(bridgeSketch()), 2));
}

TEST(AxleSites, TooLongOrTooShortALineMayNot) {
  EXPECT_TRUE(mayHave(bridgeSketch(11)));
  EXPECT_FALSE(mayHave(bridgeSketch(12)));
  EXPECT_FALSE(mayHave(bridgeSketch(1)));
}

TEST(AxleSites, ALineWithAFixedHoleAxisMayNot) {
  sketch::Sketch sketch = bridgeSketch();
  sketch.lines[2].holeAxis = lattice::Axis::kZ;
  EXPECT_FALSE(mayHave(sketch));
}

TEST(AxleSites, ALineThatMeetsOneWithAnotherFixedHoleAxisMayNot) {
  sketch::Sketch sketch = bridgeSketch();
  sketch.lines[0].holeAxis = lattice::Axis::kZ;
  EXPECT_FALSE(mayHave(sketch));
  sketch.lines[0].holeAxis = lattice::Axis::kY;
  EXPECT_TRUE(mayHave(sketch));
}

TEST(AxleSites, ALineOffTheLatticeMayNot) {
  const sketch::Sketch sketch =
      testing::sketchFrom({{{0, 0, 0}, {8, 0, 0}}, {{4, 0, 0}, {7, 4, 0}}});
  EXPECT_FALSE(mayHave(sketch, 1));
}

TEST(AxleSites, ALineThatMeetsNoneMayNot) {
  EXPECT_FALSE(mayHave(testing::lineSketch(5), 0));
}

TEST(AxleSites, AJointAboutALineNeedsAnAxle) {
  sketch::Sketch sketch = bridgeSketch();
  sketch.joints.push_back({{4, 0, 0}, {0, 1, 0}, {{2}, {0}}});
  const guide::GuidingGraph graph = testing::graphOf(sketch);
  EXPECT_TRUE(mayHaveAxle(graph, 2, kLongest));
  EXPECT_TRUE(needsAxle(graph, 2));
}

TEST(AxleSites, AJointAcrossALineAllowsNone) {
  sketch::Sketch sketch = bridgeSketch();
  sketch.joints.push_back({{4, 0, 0}, {0, 0, 1}, {{2}, {0}}});
  EXPECT_FALSE(mayHave(sketch));
}

TEST(AxleSites, ALineThatIsToStayAsOneWithAnotherAtAJointMayNot) {
  sketch::Sketch sketch = bridgeSketch();
  sketch.lines.push_back(testing::sketchFrom({{{4, 0, 0}, {4, 0, 4}}}).lines.front());
  sketch.joints.push_back({{4, 0, 0}, {0, 1, 0}, {{2, 3}, {0}}});
  EXPECT_FALSE(mayHave(sketch));
}

}  // namespace
}  // namespace liftarm::search
