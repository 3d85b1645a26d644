#include "core/helpers/prism_distance.h"

#include <algorithm>
#include <cmath>

namespace liftarm::testing {

namespace {

using lattice::Vec3;
using parts::Prism;

//! The point of a prism that is nearest to x, in closed form: across the axis and along it apart.
Vec3 nearestIn(const Prism& prism, Vec3 x) {
  const Vec3 middle = 0.5 * (prism.from + prism.to);
  const Vec3 half = 0.5 * (prism.to - prism.from);
  const Vec3 offset = x - middle;
  const double height = lattice::dot(offset, prism.axis);
  const Vec3 across = offset - height * prism.axis;
  const double square = lattice::dot(half, half);
  const double share =
      square > 0.0 ? std::clamp(lattice::dot(across, half) / square, -1.0, 1.0) : 0.0;
  const Vec3 rest = across - share * half;
  const double far = lattice::length(rest);
  return middle + share * half + (far > prism.radius ? prism.radius / far : 1.0) * rest +
         std::clamp(height, -prism.halfThickness, prism.halfThickness) * prism.axis;
}

//! The most that a prism reaches along d, times |d|.
double reach(const Prism& prism, Vec3 d) {
  const double along = lattice::dot(d, prism.axis);
  return std::max(lattice::dot(d, prism.from), lattice::dot(d, prism.to)) +
         prism.radius * lattice::length(d - along * prism.axis) +
         prism.halfThickness * std::abs(along);
}

}  // namespace

Prism drawnIn(Prism prism, double by) {
  prism.radius -= by;
  prism.halfThickness -= by;
  return prism;
}

std::optional<double> distance(const Prism& a, const Prism& b, int rounds) {
  Vec3 inA = 0.5 * (a.from + a.to);
  for (int round = 0; round < rounds; ++round) {
    const Vec3 inB = nearestIn(b, inA);
    inA = nearestIn(a, inB);
    const Vec3 d = inB - inA;
    const double apart = lattice::length(d);
    if (apart < 1e-9) {
      return 0.0;
    }
    const double gap = -reach(b, -d) - reach(a, d);
    if (gap > 0.0) {
      return gap / apart;
    }
  }
  return std::nullopt;
}

}  // namespace liftarm::testing
