#include "base/rng.h"

#include <array>
#include <cstdint>

#include <gtest/gtest.h>

namespace liftarm::base {
namespace {

TEST(Rng, SameSeedGivesSameStream) {
  Rng a(7);
  Rng b(7);
  for (int i = 0; i < 1000; ++i) {
    ASSERT_EQ(a.next(), b.next());
  }
}

TEST(Rng, DifferentSeedsGiveDifferentStreams) {
  Rng a(7);
  Rng b(8);
  int equal = 0;
  for (int i = 0; i < 100; ++i) {
    equal += a.next() == b.next() ? 1 : 0;
  }
  EXPECT_EQ(equal, 0);
}

// splitmix64 from seed 0 is published with its first outputs; xoshiro256** starts from four of
// them, and its first output is rotl(s1 * 5, 7) * 9.
TEST(Rng, FirstOutputFollowsFromThePublishedSeeding) {
  const std::uint64_t second = 0x6e789e6aa1b965f4ULL;
  const std::uint64_t product = second * 5;
  EXPECT_EQ(Rng(0).next(), ((product << 7U) | (product >> 57U)) * 9);
}

TEST(Rng, BelowStaysBelowItsBound) {
  Rng rng(3);
  for (const std::uint32_t bound : {1U, 2U, 3U, 7U, 1000U, 0x80000001U}) {
    for (int i = 0; i < 1000; ++i) {
      ASSERT_LT(rng.below(bound), bound);
    }
  }
}

TEST(Rng, BelowIsUniform) {
  Rng rng(11);
  std::array<int, 6> counts{};
  for (int i = 0; i < 60000; ++i) {
    ++counts.at(rng.below(6));
  }
  for (const int count : counts) {
    EXPECT_NEAR(count, 10000, 500);  // five standard deviations and more
  }
}

TEST(Rng, UnitLiesInTheHalfOpenIntervalWithMeanOneHalf) {
  Rng rng(5);
  double sum = 0.0;
  for (int i = 0; i < 100000; ++i) {
    const double u = rng.unit();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
  }
  EXPECT_NEAR(sum / 100000.0, 0.5, 0.005);
}

TEST(RngDeathTest, ABoundOfZeroIsABug) {
  EXPECT_DEATH(Rng(1).below(0), "positive bound");
}

}  // namespace
}  // namespace liftarm::base
