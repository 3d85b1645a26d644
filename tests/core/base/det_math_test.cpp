#include "base/det_math.h"

#include <cmath>
#include <cstdint>
#include <cstring>

#include <gtest/gtest.h>

#include "base/hash.h"

namespace liftarm::base {
namespace {

constexpr double kRelative = 1e-12;
constexpr double kPi = 3.141592653589793;

std::uint64_t bitsOf(double x) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

TEST(DetMath, ExpAgreesWithLibm) {
  for (double x = -690.0; x <= 690.0; x += 0.37) {
    const double expected = std::exp(x);
    ASSERT_NEAR(detExp(x) / expected, 1.0, kRelative) << "x = " << x;
  }
}

TEST(DetMath, ExpIsCutOffAtItsStatedEnds) {
  EXPECT_EQ(detExp(-1000.0), 0.0);
  EXPECT_EQ(detExp(1000.0), detExp(700.0));
  EXPECT_EQ(detExp(0.0), 1.0);
}

TEST(DetMath, LogAgreesWithLibm) {
  for (double x = 1e-9; x < 1e9; x *= 1.013) {
    const double expected = std::log(x);
    ASSERT_NEAR(detLog(x), expected, kRelative * (1.0 + std::abs(expected))) << "x = " << x;
  }
}

TEST(DetMath, LogUndoesExp) {
  for (double x = -50.0; x <= 50.0; x += 0.11) {
    ASSERT_NEAR(detLog(detExp(x)), x, 1e-11) << "x = " << x;
  }
}

TEST(DetMath, SineAndCosineAgreeWithLibm) {
  for (double x = -30.0; x <= 30.0; x += 0.013) {
    ASSERT_NEAR(detSin(x), std::sin(x), kRelative) << "x = " << x;
    ASSERT_NEAR(detCos(x), std::cos(x), kRelative) << "x = " << x;
  }
}

TEST(DetMath, SineAndCosineLieOnTheUnitCircle) {
  for (double x = -1000.0; x <= 1000.0; x += 1.7) {
    const double s = detSin(x);
    const double c = detCos(x);
    ASSERT_NEAR(s * s + c * c, 1.0, kRelative) << "x = " << x;
  }
}

TEST(DetMath, Atan2AgreesWithLibmInEveryQuadrant) {
  for (int i = 0; i < 720; ++i) {
    const double angle = (static_cast<double>(i) - 359.5) * kPi / 360.0;
    const double y = 3.0 * std::sin(angle);
    const double x = 3.0 * std::cos(angle);
    ASSERT_NEAR(detAtan2(y, x), std::atan2(y, x), 1e-12) << "angle = " << angle;
  }
}

TEST(DetMath, Atan2OfTheAxesAndOfZero) {
  EXPECT_NEAR(detAtan2(1.0, 0.0), kPi / 2.0, 1e-15);
  EXPECT_NEAR(detAtan2(-1.0, 0.0), -kPi / 2.0, 1e-15);
  EXPECT_NEAR(detAtan2(0.0, -1.0), kPi, 1e-15);
  EXPECT_EQ(detAtan2(0.0, 0.0), 0.0);
}

// The bits themselves, hashed: the same number must come out of every compiler and of WebAssembly.
TEST(DetMath, GivesTheSameBitsEverywhere) {
  std::uint64_t hash = 0;
  for (int i = 1; i <= 20000; ++i) {
    const double x = static_cast<double>(i) * 0.0137;
    hash = mixHash(hash, bitsOf(detExp(x)));
    hash = mixHash(hash, bitsOf(detLog(x)));
    hash = mixHash(hash, bitsOf(detSin(x)));
    hash = mixHash(hash, bitsOf(detCos(x)));
    hash = mixHash(hash, bitsOf(detAtan2(x, 1.0 - x)));
  }
  EXPECT_EQ(hash, 0xe0b42d944e7f2ea6ULL);
}

}  // namespace
}  // namespace liftarm::base
