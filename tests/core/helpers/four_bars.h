#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/rng.h"
#include "core/helpers/models.h"

namespace liftarm::testing {

//! \brief A four-bar linkage in the plane z = 0: ground along x from the origin, crank, coupler and
//! rocker, each from the end of the one before to the next, back to the start.
struct FourBar {
  std::array<double, 4> lengths{};
  std::array<lattice::Vec3, 4> pivots;  //!< bar i from pivots[i] to the next

  //! \param crank The crank's angle against the ground, radians. \return Nothing where the bars do
  //! not reach.
  static std::optional<FourBar> at(const std::array<double, 4>& lengths, double crank) {
    const auto& [ground, a, coupler, rocker] = lengths;
    const lattice::Vec3 end{ground, 0, 0};
    const lattice::Vec3 tip{ground + a * std::cos(crank), a * std::sin(crank), 0};
    const double d = lattice::length(tip);
    const double along = (d * d + rocker * rocker - coupler * coupler) / (2 * d);
    if (std::abs(along) > rocker) {
      return std::nullopt;
    }
    const double aside = std::sqrt(rocker * rocker - along * along);
    const lattice::Vec3 unit = (1 / d) * tip;
    const lattice::Vec3 square{-unit.y, unit.x, 0};
    return FourBar{lengths, {{{0, 0, 0}, end, tip, along * unit + aside * square}}};
  }
};

//! \brief How far a joint of a four-bar turns from where it stands, degrees.
struct ClosedRange {
  double from = -180;
  double to = 180;
};

//! \brief The range of the joint between bar `i - 1` and bar i, in closed form: the distance of
//! their far ends must lie between the difference and the sum of the other two bars. Turning
//! is that of bar i against bar i - 1, about z.
inline ClosedRange closedRange(const FourBar& linkage, std::size_t i) {
  const auto pivot = [&](std::size_t k) { return linkage.pivots[k % 4]; };
  const auto bar = [&](std::size_t k) { return linkage.lengths[k % 4]; };
  const double p = bar(i + 3);
  const double q = bar(i);
  const lattice::Vec3 back = pivot(i + 3) - pivot(i);
  const lattice::Vec3 forth = pivot(i + 1) - pivot(i);
  const double start = std::atan2(back.x * forth.y - back.y * forth.x, lattice::dot(back, forth));
  const auto angleAt = [&](double apart) -> std::optional<double> {
    const double cosine = (p * p + q * q - apart * apart) / (2 * p * q);
    return std::abs(cosine) < 1 ? std::optional(std::acos(cosine)) : std::nullopt;
  };
  const std::optional<double> inner = angleAt(std::abs(bar(i + 1) - bar(i + 2)));
  const std::optional<double> outer = angleAt(bar(i + 1) + bar(i + 2));
  // As if the angle were positive; its mirror image otherwise.
  const double angle = std::abs(start);
  constexpr double kTurn = 2 * std::numbers::pi;
  double low = outer.has_value() ? -*outer : -kTurn;
  low = inner.value_or(low);
  double high = inner.has_value() ? kTurn - *inner : kTurn;
  high = outer.value_or(high);
  const auto degrees = [&](double to) {
    return std::clamp((to - angle) * 360 / kTurn, -180.0, 180.0);
  };
  return start > 0 ? ClosedRange{degrees(low), degrees(high)}
                   : ClosedRange{-degrees(high), -degrees(low)};
}

//! \brief A rigid motion drawn at random: any turn, shifts of up to `reach` modules.
inline lattice::Pose randomMotion(base::Rng& rng, double reach) {
  const auto within = [&](double limit) { return limit * (2 * rng.unit() - 1); };
  model::PlacedPart part;
  for (const lattice::Vec3 axis : {lattice::Vec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
    turn(part, axis, within(180));
  }
  return {{within(reach), within(reach), within(reach)}, part.pose.rotation};
}

inline lattice::Pose after(const lattice::Pose& outer, const lattice::Pose& inner) {
  return {outer.apply(inner.position), outer.rotation * inner.rotation};
}

//! \brief Crank, coupler and rocker on a ground beam along x: 8, 2, 8 and 6 modules, of real beams
//! and pins without friction, no sketch.
inline model::Model crankAndRocker(double crank) {
  const FourBar linkage = FourBar::at({8, 2, 8, 6}, crank).value();
  const std::array<const char*, 4> beams{"40490", "32523", "40490", "32524"};
  const std::array<double, 4> layers{0, 1, 2, 1};
  model::Model model;
  for (std::size_t i = 0; i < 4; ++i) {
    const lattice::Vec3 from = linkage.pivots[i];
    const lattice::Vec3 to = linkage.pivots[(i + 1) % 4];
    const lattice::Vec3 middle = 0.5 * (from + to) + lattice::Vec3{0, 0, layers[i]};
    model.parts.push_back(beamAt(beams[i], middle, lattice::normalized(to - from), {0, 0, 1}));
    const double between = 0.5 * (layers[i] + layers[(i + 3) % 4]);
    model.parts.push_back(pinAt("3673", from + lattice::Vec3{0, 0, between}, {0, 0, 1}));
  }
  return model;
}

}  // namespace liftarm::testing
