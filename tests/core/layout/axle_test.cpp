#include "layout/axle.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "base/rng.h"

namespace liftarm::layout {
namespace {

std::uint64_t bit(int index) {
  return std::uint64_t{1} << axleBit(index);
}

std::uint64_t bits(const std::vector<int>& indices) {
  std::uint64_t all = 0;
  for (const int index : indices) {
    all |= bit(index);
  }
  return all;
}

std::vector<int> only(const std::string& part) {
  return {axlePartIndex(part)};
}

TEST(Axle, PartsAreTheStraightAxlesOfTheCatalogue) {
  std::set<int> plain;
  std::set<int> stopped;
  for (const AxlePart& axle : axleParts()) {
    (axle.stopped ? stopped : plain).insert(axle.length);
  }
  EXPECT_EQ(plain, (std::set<int>{3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
  EXPECT_EQ(stopped, (std::set<int>{3, 4, 5, 8}));
  EXPECT_EQ(axlePartIndex("3713"), -1);
  EXPECT_EQ(axlePartIndex("43093"), -1) << "half of it is a pin";
}

TEST(Axle, StopHoldsTheLastBeamWithoutABush) {
  const Axle axle = layAxle({3, bits({0, 3}), 0}, allAxleParts());
  ASSERT_TRUE(axle.used());
  EXPECT_TRUE(axleParts()[static_cast<std::size_t>(axle.part)].stopped);
  EXPECT_EQ(axle.length(), 5);
  EXPECT_EQ(axle.bushCount(), 3);
  EXPECT_EQ(axle.headCount(), 2);
}

TEST(Axle, OneBushSharesAGapOfOneModule) {
  const Axle axle = layAxle({2, bits({0, 2}), 0}, only("3706"));
  EXPECT_EQ(axle.bushCount(), 3);
  EXPECT_TRUE(axle.hasBush(1));
}

TEST(Axle, NothingForbiddenIsEnteredWhereThatCanBe) {
  // The foot of a leg on the ground: only a stop holds what lies there.
  const Axle axle = layAxle({4, bits({0, 3, 4}), bits({-3, -2, -1})}, allAxleParts());
  EXPECT_EQ(axle.start, 0);
  EXPECT_TRUE(axle.turned);
}

TEST(Axle, CoversALineWithAFreeEnd) {
  const Axle axle = layAxle({6, bits({0}), 0}, allAxleParts());
  EXPECT_LE(axle.start, 0);
  EXPECT_GE(axle.last(), 6);
  EXPECT_EQ(heldOn(axle, bits({0})), bits({0}));
}

TEST(Axle, IsNoneWhereALineIsTooLong) {
  EXPECT_FALSE(layAxle({12, bits({0}), 0}, allAxleParts()).used());
  EXPECT_FALSE(layAxle({5, bits({0}), 0}, only("4519")).used());
}

TEST(Axle, HoldsNothingWhereItHasNoRoomForBushes) {
  const Axle axle = layAxle({4, bits({0, 4}), 0}, only("32073"));
  EXPECT_TRUE(axle.used());
  EXPECT_EQ(heldOn(axle, bits({0, 4})), 0U);
}

TEST(Axle, BeamsWithAGapBetweenThemSlide) {
  Axle axle;
  axle.part = axlePartIndex("32073");
  axle.bushes = 0b10001;
  EXPECT_EQ(heldOn(axle, bits({1, 2, 3})), bits({1, 2, 3}));
  EXPECT_EQ(heldOn(axle, bits({1, 3})), 0U);
  EXPECT_EQ(heldOn(axle, bits({2, 3})), 0U);
}

TEST(Axle, AStopHoldsOnItsOwnSideAlone) {
  Axle axle;
  axle.part = axlePartIndex("15462");
  axle.bushes = 0b00010;
  EXPECT_EQ(heldOn(axle, bits({0})), 0U);
  axle.turned = true;
  EXPECT_EQ(heldOn(axle, bits({0})), bits({0}));
}

//! The least that an axle costs which holds all beams, by trying every set of bushes.
std::optional<double> leastCost(const AxleSite& site) {
  std::optional<double> least;
  Axle axle;
  for (axle.part = 0; axle.part < static_cast<int>(axleParts().size()); ++axle.part) {
    for (axle.start = -kAxleReach; axle.start <= 0; ++axle.start) {
      if (axle.last() < site.edges || axle.last() > site.edges + kAxleReach) {
        continue;
      }
      axle.seats = static_cast<std::uint32_t>(site.seats >> axleBit(axle.start));
      for (axle.bushes = 0; axle.bushes < 1U << static_cast<unsigned>(axle.length());
           ++axle.bushes) {
        for (const bool turned : {false, true}) {
          axle.turned = turned;
          const bool free = (axle.bushes & axle.seats) == 0;
          if (free && heldOn(axle, site.seats) == site.seats && (!least || axle.cost() < *least)) {
            least = axle.cost();
          }
        }
      }
    }
  }
  return least;
}

TEST(Axle, IsTheCheapestThatHoldsAllBeams) {
  base::Rng rng(5);
  int held = 0;
  for (int i = 0; i < 60; ++i) {
    AxleSite site{2 + static_cast<int>(rng.below(4)), 0, 0};
    for (const int end : {0, site.edges}) {
      for (std::uint32_t n = rng.below(3); n > 0; --n) {
        site.seats |= bit(end - 2 + static_cast<int>(rng.below(5)));
      }
    }
    const std::optional<double> least = leastCost(site);
    const Axle axle = layAxle(site, allAxleParts());
    ASSERT_TRUE(axle.used());
    if (site.seats == 0) {
      continue;
    }
    EXPECT_EQ(least.has_value(), heldOn(axle, site.seats) == site.seats);
    if (least) {
      ++held;
      EXPECT_NEAR(axle.cost(), *least, 1e-9);
    }
  }
  EXPECT_GT(held, 30);
}

}  // namespace
}  // namespace liftarm::layout
