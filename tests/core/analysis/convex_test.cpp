#include "analysis/convex.h"

#include <cmath>
#include <cstdint>
#include <optional>

#include <gtest/gtest.h>

#include "base/rng.h"
#include "core/helpers/prism_distance.h"

namespace liftarm::analysis {
namespace {

using lattice::Vec3;
using parts::Prism;

constexpr double kTolerance = 0.03;
constexpr double kPi = 3.14159265358979323846;

std::optional<double> drawnInDistance(const Prism& a, const Prism& b, int rounds = 4000) {
  return testing::distance(
      testing::drawnIn(a, kTolerance / 2), testing::drawnIn(b, kTolerance / 2), rounds);
}

class PrismDraw {
 public:
  explicit PrismDraw(std::uint64_t seed) : rng_(seed) {}

  double between(double low, double high) { return low + (high - low) * rng_.unit(); }

  int below(int n) { return static_cast<int>(rng_.below(static_cast<std::uint32_t>(n))); }

  Vec3 direction() {
    for (;;) {
      const Vec3 v{between(-1, 1), between(-1, 1), between(-1, 1)};
      if (lattice::dot(v, v) < 1.0 && lattice::dot(v, v) > 0.01) {
        return lattice::normalized(v);
      }
    }
  }

  //! Beams, barrels, collars and heads.
  Prism shape(Vec3 middle, Vec3 along, Vec3 axis) {
    constexpr double kRadii[] = {0.45, 0.4, 0.3, 0.5};
    constexpr double kHalves[] = {0.5, 0.25, 0.05, 1.0};
    const double length = below(3) == 0 ? 0.0 : below(14);
    return {middle - (length / 2) * along,
            middle + (length / 2) * along,
            axis,
            kRadii[below(4)],
            kHalves[below(4)]};
  }

  //! Anywhere, turned anyhow.
  Prism anyhow() {
    const Vec3 axis = direction();
    return shape({between(-4, 4), between(-4, 4), between(-2, 2)},
                 lattice::normalized(lattice::cross(axis, direction())),
                 axis);
  }

  //! Holes along or across z, turned about z: what turns on pins.
  Prism onPin() {
    const double angle = below(2) == 0 ? between(-kPi, kPi) : below(72) * kPi / 36;
    const Vec3 along{std::cos(angle), std::sin(angle), 0};
    const Vec3 across{-along.y, along.x, 0};
    const Vec3 middle = (0.5 * below(12)) * along + (0.5 * below(12)) * across;
    return shape(
        middle + Vec3{0, 0, 0.5 * below(4)}, along, below(2) == 0 ? Vec3{0, 0, 1} : across);
  }

 private:
  base::Rng rng_;
};

Prism shifted(Prism prism, Vec3 by) {
  prism.from = prism.from + by;
  prism.to = prism.to + by;
  return prism;
}

//! Compares overlap() with the proofs. \return How many pairs were proved either way.
int expectAgreement(const Prism& a, const Prism& b) {
  constexpr double kRounding = 2e-6;  // modules
  const std::optional<double> apart = drawnInDistance(a, b);
  if (!apart.has_value() || (*apart > 0.0 && *apart < kRounding)) {
    return 0;
  }
  EXPECT_EQ(overlap(a, b, kTolerance), *apart == 0.0) << "apart by " << *apart;
  EXPECT_EQ(overlap(b, a, kTolerance), *apart == 0.0) << "apart by " << *apart;
  return 1;
}

TEST(Convex, OverlapAgreesWithProofsOnPrismsAnywhere) {
  PrismDraw draw(1);
  int proved = 0;
  for (int i = 0; i < 6000; ++i) {
    const Prism a = draw.anyhow();
    proved += expectAgreement(a, draw.anyhow());
  }
  EXPECT_GT(proved, 5900);
}

TEST(Convex, OverlapAgreesWithProofsOnWhatTurnsOnPins) {
  PrismDraw draw(2);
  int proved = 0;
  for (int i = 0; i < 6000; ++i) {
    const Prism a = draw.onPin();
    proved += expectAgreement(a, draw.onPin());
  }
  EXPECT_GT(proved, 5900);
}

double rounded(double value) {
  return std::round(1e9 * value) / 1e9;
}

Vec3 rounded(Vec3 v) {
  return {rounded(v.x), rounded(v.y), rounded(v.z)};
}

//! Turned about x and shifted, as a file with nine decimals has it: axes are no longer of unit
//! length.
Prism asWritten(const Prism& prism, double angle, Vec3 shift) {
  const auto turned = [&](Vec3 v) {
    return Vec3{v.x,
                std::cos(angle) * v.y - std::sin(angle) * v.z,
                std::sin(angle) * v.y + std::cos(angle) * v.z};
  };
  return {rounded(turned(prism.from) + shift),
          rounded(turned(prism.to) + shift),
          rounded(turned(prism.axis)),
          prism.radius,
          prism.halfThickness};
}

TEST(Convex, OverlapAgreesWithProofsWherePosesAreRounded) {
  PrismDraw draw(4);
  int proved = 0;
  for (int i = 0; i < 6000; ++i) {
    // Side by side on one line, as beams and bushes are on an axle; turned anyhow.
    const Vec3 axis = i % 2 == 0 ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
    const Prism a = draw.shape({}, {1, 0, 0}, axis);
    const Prism b = draw.shape((0.5 * draw.below(5)) * axis, {1, 0, 0}, axis);
    const double angle = draw.between(-kPi, kPi);
    const Vec3 shift{std::floor(draw.between(-50, 50)), 7, std::floor(draw.between(-50, 50))};
    proved += expectAgreement(asWritten(a, angle, shift), asWritten(b, angle, shift));
  }
  EXPECT_GT(proved, 5900);
}

TEST(Convex, OverlapAgreesWithProofsWherePrismsNearlyTouch) {
  PrismDraw draw(3);
  int proved = 0;
  for (int i = 0; i < 2000; ++i) {
    const Prism a = i % 2 == 0 ? draw.anyhow() : draw.onPin();
    const Prism b = i % 2 == 0 ? draw.anyhow() : draw.onPin();
    const Vec3 away = draw.direction();
    double in = 0.0;
    double out = 40.0;
    for (int halving = 0; halving < 24; ++halving) {
      const double middle = (in + out) / 2;
      const std::optional<double> apart = drawnInDistance(a, shifted(b, middle * away), 300);
      (apart.value_or(0.0) > 0.0 ? out : in) = middle;
    }
    const double nudge = std::pow(10.0, draw.between(-5, -1)) * (draw.below(2) == 0 ? 1 : -1);
    proved += expectAgreement(a, shifted(b, (out + nudge) * away));
  }
  EXPECT_GT(proved, 1700);
}

}  // namespace
}  // namespace liftarm::analysis
