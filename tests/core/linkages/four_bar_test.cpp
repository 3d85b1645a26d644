#include "linkages/four_bar.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "parts/catalogue.h"

namespace liftarm::linkages {
namespace {

FourBar barWith(int crank, int coupler, int rocker, int frame) {
  FourBar bar;
  bar.crank = crank;
  bar.rocker = rocker;
  bar.frame = frame;
  bar.coupler.beam = {coupler, 0, -1.0};
  bar.coupler.rockerHole = coupler;
  bar.coupler.pointHole = coupler;
  bar.coupler.length = coupler;
  bar.coupler.point = {static_cast<double>(coupler), 0.0};
  return bar;
}

TEST(FourBar, LinksKeepTheirLengthsAllTheWayRound) {
  const FourBar bar = barWith(2, 7, 6, 8);
  for (const Point turn : turnsOf(48)) {
    const FourBarPose pose = poseOf(bar, turn);
    EXPECT_NEAR(length(pose.crankPin), 2.0, 1e-12);
    EXPECT_NEAR(length(pose.rockerPin - pose.crankPin), 7.0, 1e-12);
    EXPECT_NEAR(length(pose.rockerPin - Point{8.0, 0.0}), 6.0, 1e-12);
  }
}

TEST(FourBar, AParallelogramOfRockersDoesNotGoRound) {
  EXPECT_TRUE(isCrankRocker(2, 7, 6, 8));
  EXPECT_FALSE(isCrankRocker(4, 8, 4, 8));
  EXPECT_FALSE(isCrankRocker(6, 2, 7, 8));
}

// Where the crank lies along the frame, the triangle of coupler and rocker is 3-4-5.
TEST(FourBar, TransmissionAngleIsThatOfTheTriangleWithTheCrankInLine) {
  EXPECT_NEAR(transmissionCosine(1, 3, 4, 4), (9.0 + 16.0 - 9.0) / 24.0, 1e-12);
  EXPECT_NEAR(transmissionCosine(1, 3, 4, 6), 1.0, 1e-12);
}

// Hoeken's linkage, twice its usual size: 2, 5, 5, 4 with the point as far again.
TEST(FourBar, HoekensPointGoesStraightForHalfATurn) {
  FourBar bar = barWith(2, 5, 5, 4);
  bar.coupler.point = {10.0, 0.0};
  double low = 1e9;
  double high = -1e9;
  const std::vector<Point> turns = turnsOf(360);
  for (int degrees = 95; degrees <= 265; ++degrees) {
    const double v = poseOf(bar, turns[static_cast<std::size_t>(degrees)]).point.v;
    low = std::min(low, v);
    high = std::max(high, v);
  }
  EXPECT_LT(high - low, 0.05);
}

TEST(FourBar, EveryLinkageOfTheTableSatisfiesItsLimits) {
  const FourBarLimits limits;
  for (const double coupler : {3.0, 4.4721359549995796, 9.0}) {
    const auto found = crankRockers(coupler, limits);
    EXPECT_FALSE(found.empty());
    for (const auto& [crank, rocker, frame] : found) {
      EXPECT_TRUE(isCrankRocker(crank, coupler, rocker, frame));
      EXPECT_LE(transmissionCosine(crank, coupler, rocker, frame), 0.8660254037844387 + 1e-9);
      EXPECT_TRUE(crankPassesRocker(crank, coupler, rocker, frame));
    }
  }
}

TEST(FourBar, CouplersAreDifferentUpToReversal) {
  const std::vector<Coupler> couplers = allCouplers(8);
  for (const Coupler& coupler : couplers) {
    EXPECT_NE(coupler.crankHole, coupler.rockerHole);
    EXPECT_NE(coupler.pointHole, coupler.crankHole);
    EXPECT_NE(coupler.pointHole, coupler.rockerHole);
    EXPECT_GT(coupler.length, 0.9);
  }
}

// The shapes are written down for a wing that does not know the catalogue.
TEST(FourBar, BentCouplersAreBeamsOfTheCatalogue) {
  constexpr const char* kParts[] = {"32526", "32140", "6629", "32271", "32348"};
  for (std::size_t i = 0; i < kBentCouplers.size(); ++i) {
    const parts::Part* const part = parts::Catalogue::builtIn().find(kParts[i]);
    ASSERT_NE(part, nullptr);
    std::vector<Point> holes;
    for (const parts::Feature& feature : part->features) {
      if (feature.kind == parts::FeatureKind::kPinHole) {
        holes.push_back({feature.center.x, feature.center.y});
      }
    }
    const CouplerBeam& beam = kBentCouplers[i];
    ASSERT_EQ(static_cast<int>(holes.size()), beam.first + beam.second + 1) << kParts[i];
    // The distances between holes, sorted, are the same.
    const auto distances = [](const std::vector<Point>& points) {
      std::vector<double> found;
      for (const Point a : points) {
        for (const Point b : points) {
          found.push_back(length(a - b));
        }
      }
      std::sort(found.begin(), found.end());
      return found;
    };
    std::vector<Point> ours;
    for (int h = 0; h <= beam.first + beam.second; ++h) {
      ours.push_back(holeOf(beam, 1, h));
    }
    const std::vector<double> wanted = distances(holes);
    const std::vector<double> found = distances(ours);
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      EXPECT_NEAR(found[k], wanted[k], 1e-6) << kParts[i];
    }
  }
}

}  // namespace
}  // namespace liftarm::linkages
