#include "base/hash.h"

#include <cstdint>
#include <set>

#include <gtest/gtest.h>

namespace liftarm::base {
namespace {

TEST(MixHash, DependsOnTheOrderOfTheWords) {
  EXPECT_NE(mixHash(mixHash(0, 1), 2), mixHash(mixHash(0, 2), 1));
}

TEST(MixHash, ZeroWordsStillCount) {
  EXPECT_NE(mixHash(mixHash(1, 0), 0), mixHash(1, 0));
}

TEST(MixHash, SmallWordsDoNotCollide) {
  std::set<std::uint64_t> seen;
  for (std::uint64_t a = 0; a < 100; ++a) {
    for (std::uint64_t b = 0; b < 100; ++b) {
      seen.insert(mixHash(mixHash(0, a), b));
    }
  }
  EXPECT_EQ(seen.size(), 10000U);
}

}  // namespace
}  // namespace liftarm::base
