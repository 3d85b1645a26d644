#include "layout/stadium.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/rng.h"

namespace liftarm::layout {
namespace {

using lattice::Axis;
using lattice::Vec3;

//! How deep a point lies in the beam: positive inside, zero on its surface.
double depth(const Stadium& beam, Vec3 p) {
  const int k = lattice::index(beam.axis);
  Vec3 span = beam.to - beam.from;
  Vec3 toPoint = p - beam.from;
  const double along = kBeamHalfThickness - std::abs(toPoint[k]);
  toPoint[k] = 0.0;
  const double spanSquared = lattice::dot(span, span);
  const double t =
      spanSquared > 0.0 ? std::clamp(lattice::dot(toPoint, span) / spanSquared, 0.0, 1.0) : 0.0;
  return std::min(along, kBeamRadius - lattice::length(toPoint - t * span));
}

//! The deepest that any point of a fine lattice lies in both beams.
double deepestCommonPoint(const Stadium& a, const Stadium& b) {
  constexpr double kStep = 0.05;
  Vec3 low;
  Vec3 high;
  for (int i = 0; i < 3; ++i) {
    low[i] = std::max(std::min(a.from[i], a.to[i]), std::min(b.from[i], b.to[i])) - 0.5;
    high[i] = std::min(std::max(a.from[i], a.to[i]), std::max(b.from[i], b.to[i])) + 0.5;
    if (high[i] < low[i]) {
      return -1.0;
    }
  }
  double best = -1.0;
  for (double x = low.x; x <= high.x; x += kStep) {
    for (double y = low.y; y <= high.y; y += kStep) {
      for (double z = low.z; z <= high.z; z += kStep) {
        best = std::max(best, std::min(depth(a, {x, y, z}), depth(b, {x, y, z})));
      }
    }
  }
  return best;
}

int between(base::Rng* rng, int low, int high) {
  return low + static_cast<int>(rng->below(static_cast<std::uint32_t>(high - low + 1)));
}

//! A beam through whole cells near the origin, along an axis or, where `slanted`, along a 3-4-5
//! line.
Stadium randomBeam(base::Rng* rng, bool slanted) {
  Stadium beam;
  beam.axis = lattice::axisFromIndex(between(rng, 0, 2));
  const int k = lattice::index(beam.axis);
  Vec3 direction;
  const int u = (k + between(rng, 1, 2)) % 3;
  const int v = 3 - k - u;
  direction[u] = slanted ? 0.6 : 1.0;
  direction[v] = slanted ? (between(rng, 0, 1) == 0 ? 0.8 : -0.8) : 0.0;
  const Vec3 origin{static_cast<double>(between(rng, -2, 2)),
                    static_cast<double>(between(rng, -2, 2)),
                    static_cast<double>(between(rng, -2, 2))};
  beam.from = origin + static_cast<double>(between(rng, -3, 0)) * direction;
  beam.to = beam.from + static_cast<double>(between(rng, 1, 5)) * direction;
  return beam;
}

void compareWithSampling(bool slantedA, bool slantedB, std::uint64_t seed) {
  base::Rng rng(seed);
  int hits = 0;
  for (int i = 0; i < 250; ++i) {
    const Stadium a = randomBeam(&rng, slantedA);
    const Stadium b = randomBeam(&rng, slantedB);
    const double deep = deepestCommonPoint(a, b);
    const bool says = overlap(a, b);
    hits += says ? 1 : 0;
    // A point deeper than the contact tolerance in both proves a collision; where none comes close
    // to the surfaces of both there is none. Between the two the lattice is too coarse to tell.
    if (deep > 0.05) {
      EXPECT_TRUE(says) << "pair " << i << " shares a point " << deep << " deep";
    } else if (deep < -0.05) {
      EXPECT_FALSE(says) << "pair " << i;
    }
  }
  EXPECT_GT(hits, 10);
}

TEST(Stadium, OverlapAgreesWithSampledPointsOnTheLattice) {
  compareWithSampling(false, false, 1);
}

TEST(Stadium, OverlapAgreesWithSampledPointsWhereOneBeamIsSlanted) {
  compareWithSampling(true, false, 2);
}

TEST(Stadium, OverlapAgreesWithSampledPointsWhereBothAreSlanted) {
  compareWithSampling(true, true, 3);
}

TEST(Stadium, OverlapIsSymmetric) {
  base::Rng rng(4);
  for (int i = 0; i < 2000; ++i) {
    const Stadium a = randomBeam(&rng, rng.below(2) == 0);
    const Stadium b = randomBeam(&rng, rng.below(2) == 0);
    EXPECT_EQ(overlap(a, b), overlap(b, a));
  }
}

TEST(Stadium, OverlapDoesNotDependOnTheDirectionOfABeam) {
  base::Rng rng(5);
  for (int i = 0; i < 2000; ++i) {
    const Stadium a = randomBeam(&rng, rng.below(2) == 0);
    const Stadium b = randomBeam(&rng, rng.below(2) == 0);
    EXPECT_EQ(overlap(a, b), overlap({a.to, a.from, a.axis}, {b.to, b.from, b.axis}));
  }
}

TEST(Stadium, BeamsOnNeighbouringLayersOnlyTouch) {
  EXPECT_FALSE(overlap({{0, 0, 0}, {4, 0, 0}, Axis::kZ}, {{0, 0, 1}, {4, 0, 1}, Axis::kZ}));
}

TEST(Stadium, BeamsEndToEndOnlyTouch) {
  EXPECT_FALSE(overlap({{0, 0, 0}, {4, 0, 0}, Axis::kZ}, {{5, 0, 0}, {9, 0, 0}, Axis::kZ}));
}

TEST(Stadium, BeamsSideBySideOnlyTouch) {
  EXPECT_FALSE(overlap({{0, 0, 0}, {4, 0, 0}, Axis::kZ}, {{0, 1, 0}, {4, 1, 0}, Axis::kY}));
}

TEST(Stadium, BeamCollidesWithItself) {
  const Stadium beam{{0, 0, 0}, {3, 4, 0}, Axis::kZ};
  EXPECT_TRUE(overlap(beam, beam));
}

TEST(Stadium, CrossingBeamsOfOneLayerCollide) {
  EXPECT_TRUE(overlap({{-2, 0, 0}, {2, 0, 0}, Axis::kZ}, {{0, -2, 0}, {0, 2, 0}, Axis::kZ}));
}

TEST(Stadium, CrossDistanceIsTakenAcrossTheHoleAxis) {
  const Stadium beam{{0, 0, 0}, {4, 0, 0}, Axis::kZ};
  EXPECT_DOUBLE_EQ(crossDistance(beam, {2, 2, 0.5}), 2.0);
  EXPECT_DOUBLE_EQ(crossDistance(beam, {7, 4, 0}), 5.0);
}

TEST(Stadium, CrossDistanceIsLargeForCellsOfOtherLayers) {
  EXPECT_GT(crossDistance({{0, 0, 0}, {4, 0, 0}, Axis::kZ}, {2, 0, 1}), 1e6);
}

}  // namespace
}  // namespace liftarm::layout
