#include <gtest/gtest.h>

#include "linkages/four_bar.h"
#include "linkages/path_match.h"
#include "linkages/path_shape.h"

namespace liftarm::linkages {
namespace {

std::vector<Point> ellipse(double a, double b, int count) {
  std::vector<Point> points;
  for (const Point turn : turnsOf(count)) {
    points.push_back({a * turn.u, b * turn.v});
  }
  return points;
}

std::vector<Point> placed(const std::vector<Point>& points, const Placement& placement) {
  std::vector<Point> moved;
  for (const Point p : points) {
    moved.push_back(placement.apply(p));
  }
  return moved;
}

ShapePoints shape(const std::vector<Point>& points) {
  const std::vector<Point> same = resample(points, true, kShapePoints);
  ShapePoints found;
  std::copy(same.begin(), same.end(), found.begin());
  return found;
}

TEST(PathShape, ResampledPointsAreEquallyFarApartAlongTheLine) {
  const std::vector<Point> corner{{0, 0}, {3, 0}, {3, 4}};
  const std::vector<Point> points = resample(corner, false, 8);
  ASSERT_EQ(points.size(), 8U);
  EXPECT_NEAR(points.back().v, 4.0, 1e-12);
  for (std::size_t i = 1; i < points.size(); ++i) {
    EXPECT_NEAR(length(points[i] - points[i - 1]), 1.0, 1e-12);
  }
}

TEST(PathShape, ACircleHasOneCoefficientItsRadius) {
  const auto sizes = sizesOf(coefficientsOf(shape(ellipse(3, 3, 360))));
  EXPECT_NEAR(sizes[0], 3.0, 2e-3);
  for (std::size_t k = 1; k < sizes.size(); ++k) {
    EXPECT_NEAR(sizes[k], 0.0, 2e-3);
  }
}

TEST(PathShape, SizesChangeNeitherWithPlaceNorTurnNorMirrorNorDirection) {
  std::vector<Point> egg = ellipse(4, 2, 200);
  for (Point& p : egg) {
    p.v *= 1.0 + 0.1 * p.u;
  }
  const auto wanted = sizesOf(coefficientsOf(shape(egg)));
  const Point turn = turnsOf(7)[2];
  std::vector<Point> moved = placed(egg, {turn, true, {5, -3}});
  for (const bool reversed : {false, true}) {
    if (reversed) {
      std::reverse(moved.begin(), moved.end());
    }
    const auto found = sizesOf(coefficientsOf(shape(moved)));
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      EXPECT_NEAR(found[k], wanted[k], 5e-3);
    }
  }
}

TEST(PathMatch, RefiningFindsTheTurnThatACurveWasGiven) {
  const std::vector<Point> curve = ellipse(4, 2, 120);
  const Placement wanted{turnsOf(360)[30], false, {2, 1}};
  const DrawnPath path{placed(ellipse(4, 2, 64), wanted), true};
  const Match found = refine(path, curve, {turnsOf(360)[29], false, {1.95, 1.02}}, Turns::kAny);
  EXPECT_LT(found.error, 0.01);
  EXPECT_NEAR(found.placement.turn.u, wanted.turn.u, 0.01);
}

TEST(PathMatch, AnOpenPathThatIsAPieceOfTheCurveHasNoError) {
  const std::vector<Point> curve = ellipse(4, 2, 120);
  const std::vector<Point> piece(curve.begin() + 10, curve.begin() + 40);
  EXPECT_LT(refine({piece, false}, curve, {}, Turns::kAny).error, 1e-9);
}

TEST(PathMatch, QuarterTurnsStayQuarterTurns) {
  const std::vector<Point> curve = ellipse(4, 2, 60);
  const DrawnPath path{placed(curve, {turnsOf(36)[3], false, {}}), true};
  const auto [placement, left] = bestFit(curve, path.points, false, Turns::kQuarter);
  EXPECT_NEAR(std::abs(placement.turn.u) + std::abs(placement.turn.v), 1.0, 1e-12);
  EXPECT_GT(left, 0.1);
}

}  // namespace
}  // namespace liftarm::linkages
