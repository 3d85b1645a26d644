#include "sketch/snap.h"

#include <cmath>

#include <gtest/gtest.h>

namespace liftarm::sketch {
namespace {

using lattice::Vec3;

Line drawn(Vec3 from, Vec3 to) {
  Line result;
  result.from = from;
  result.to = to;
  result.length = static_cast<int>(std::lround(lattice::length(to - from)));
  return result;
}

double worstLength(const std::vector<Line>& lines) {
  double worst = 0.0;
  for (const Line& each : lines) {
    worst = std::max(worst, std::abs(lattice::length(each.to - each.from) - each.length));
  }
  return worst;
}

//! Equilateral triangles of side `side` with coordinates rounded as drawing programs do, turned by
//! an angle whose cosine and sine are given.
std::vector<Line> triangles(int count, double side, double cosine, double sine) {
  const double height = side * std::sqrt(3.0) / 2.0;
  const auto point = [&](int i, int j) {
    const double x = side * i + 0.5 * side * j;
    const double y = height * j;
    return Vec3{std::round(1e4 * (cosine * x - sine * y)) / 1e4,
                std::round(1e4 * (sine * x + cosine * y)) / 1e4,
                0.0};
  };
  std::vector<Line> lines;
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      lines.push_back(drawn(point(i, j), point(i + 1, j)));
      lines.push_back(drawn(point(i, j), point(i, j + 1)));
      lines.push_back(drawn(point(i + 1, j), point(i, j + 1)));
    }
  }
  return lines;
}

TEST(Snap, LeavesALatticeSketchBitForBitAsItIs) {
  std::vector<Line> lines{
      drawn({0, 0, 0}, {3, 4, 0}), drawn({3, 4, 0}, {3, 4, 7}), drawn({0, 0, 0}, {-5, 0, 12})};
  const std::vector<Line> before = lines;
  EXPECT_EQ(snapToWholeLengths(lines).moved, 0.0);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(lines[i].from, before[i].from);
    EXPECT_EQ(lines[i].to, before[i].to);
  }
}

TEST(Snap, FindsTheExactHeightOfARoundedTriangle) {
  std::vector<Line> lines{drawn({0, 0, 0}, {5, 0, 0}),
                          drawn({0, 0, 0}, {2.5, 0, 4.3301}),
                          drawn({5, 0, 0}, {2.5, 0, 4.3301})};
  snapToWholeLengths(lines);
  EXPECT_EQ(lines[0].from, (Vec3{0, 0, 0}));
  EXPECT_EQ(lines[0].to, (Vec3{5, 0, 0}));
  EXPECT_NEAR(lines[1].to.z, 2.5 * std::sqrt(3.0), 1e-10);
  EXPECT_EQ(lines[1].to, lines[2].to);
}

TEST(Snap, MakesAllLengthsWholeInAWebOffTheLattice) {
  std::vector<Line> lines = triangles(8, 4.0, 0.96, 0.28);
  EXPECT_GT(worstLength(lines), 1e-6);
  const SnapReport report = snapToWholeLengths(lines);
  EXPECT_LT(worstLength(lines), 1e-9);
  EXPECT_LT(report.residual, 1e-9);
  EXPECT_LT(report.moved, 1e-3);
}

TEST(Snap, KeepsSharedEndPointsShared) {
  std::vector<Line> lines = triangles(4, 3.0, 0.8, 0.6);
  std::vector<Line> before = lines;
  snapToWholeLengths(lines);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_EQ(before[i].from == before[j].from, lines[i].from == lines[j].from);
      EXPECT_EQ(before[i].to == before[j].from, lines[i].to == lines[j].from);
    }
  }
}

TEST(Snap, WeldsEndPointsThatNearlyAgree) {
  std::vector<Line> lines{drawn({0, 0, 0}, {5, 0, 0}), drawn({5.02, 0, 0.01}, {5.02, 0, 4.01})};
  snapToWholeLengths(lines);
  EXPECT_EQ(lines[1].from, (Vec3{5, 0, 0}));
  EXPECT_EQ(lines[1].to, (Vec3{5, 0, 4}));
}

TEST(Snap, MovesTheLooseEndAndNotTheWholeNumberedOne) {
  std::vector<Line> lines{drawn({0, 0, 0}, {4.97, 0, 0})};
  snapToWholeLengths(lines);
  EXPECT_EQ(lines[0].from, (Vec3{0, 0, 0}));
  EXPECT_EQ(lines[0].to, (Vec3{5, 0, 0}));
}

TEST(Snap, MovesWholeNumberedEndsWhereNothingElseCanGive) {
  std::vector<Line> lines{drawn({0, 0, 0}, {12, 12, 0})};  // 16.97
  const SnapReport report = snapToWholeLengths(lines);
  EXPECT_LT(worstLength(lines), 1e-9);
  EXPECT_LT(report.moved, 0.02);
}

TEST(Snap, KeepsALineInItsPlaneAndAlongItsAxis) {
  std::vector<Line> lines{drawn({0, 0.01, 0}, {4.98, 0, 0.02}),
                          drawn({0, 0.01, 0}, {2, 0.03, 3.49})};
  snapToWholeLengths(lines);
  EXPECT_EQ(lines[0].from.y, lines[0].to.y);
  EXPECT_EQ(lines[0].from.z, lines[0].to.z);
  EXPECT_EQ(lines[1].from.y, lines[1].to.y);
}

TEST(Snap, KeepsAnEndPointAtTheNodeOfAnotherLine) {
  // The second line ends at the third node of the first, which is off the lattice and rounded.
  std::vector<Line> lines{drawn({0, 0, 0}, {3, 0, 5.1962}),
                          drawn({1.5, 0, 2.598}, {6.5, 0, 2.598})};
  snapToWholeLengths(lines);
  EXPECT_LT(lattice::length(nodeOfLine(lines[0], 3) - lines[1].from), 1e-9);
  EXPECT_LT(worstLength(lines), 1e-9);
}

TEST(Snap, KeepsACrossingAtNodesOfBothLines) {
  std::vector<Line> lines{drawn({0, 0, 0}, {3, 0, 5.196}), drawn({3, 0, 0}, {0, 0, 5.196})};
  snapToWholeLengths(lines);
  EXPECT_LT(lattice::length(nodeOfLine(lines[0], 3) - nodeOfLine(lines[1], 3)), 1e-9);
}

TEST(Snap, KeepsLinesStraightThroughASharedEndPoint) {
  std::vector<Line> lines{drawn({0.01, 0, 0}, {1.51, 0, 2.5982}),
                          drawn({1.51, 0, 2.5982}, {4.0102, 0, 6.9282})};
  snapToWholeLengths(lines);
  const Vec3 first = lattice::normalized(lines[0].to - lines[0].from);
  const Vec3 second = lattice::normalized(lines[1].to - lines[1].from);
  EXPECT_LT(lattice::length(first - second), 1e-9);
}

TEST(Snap, ReportsWhatContradictingLengthsLeave) {
  // Five modules and five modules, end to end in a straight line, cannot span 9.96.
  std::vector<Line> lines{drawn({0, 0, 0}, {4.98, 0, 0}),
                          drawn({4.98, 0, 0}, {9.96, 0, 0}),
                          drawn({0, 0, 0}, {9.96, 0, 0}),
                          drawn({9.96, 0, 0}, {0, 0, 0})};
  lines[3].length = 9;
  const SnapReport report = snapToWholeLengths(lines);
  EXPECT_GT(report.residual, 1e-3);
  EXPECT_GE(report.worstLine, 0);
}

TEST(Snap, IsItsOwnFixedPoint) {
  std::vector<Line> lines = triangles(5, 4.0, 0.6, 0.8);
  snapToWholeLengths(lines);
  EXPECT_EQ(snapToWholeLengths(lines).moved, 0.0);
}

}  // namespace
}  // namespace liftarm::sketch
