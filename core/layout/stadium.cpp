#include "layout/stadium.h"

#include <algorithm>
#include <cmath>

namespace liftarm::layout {

namespace {

using lattice::Axis;
using lattice::Vec3;

struct Point2 {
  double u = 0.0;
  double v = 0.0;
};

double squaredDistance(Point2 p, Point2 a, Point2 b) {
  const double du = b.u - a.u;
  const double dv = b.v - a.v;
  const double lengthSquared = du * du + dv * dv;
  double t = 0.0;
  if (lengthSquared > 0.0) {
    t = std::clamp(((p.u - a.u) * du + (p.v - a.v) * dv) / lengthSquared, 0.0, 1.0);
  }
  const double eu = p.u - a.u - t * du;
  const double ev = p.v - a.v - t * dv;
  return eu * eu + ev * ev;
}

double side(Point2 a, Point2 b, Point2 p) {
  return (b.u - a.u) * (p.v - a.v) - (b.v - a.v) * (p.u - a.u);
}

double squaredSegmentDistance(Point2 a, Point2 b, Point2 c, Point2 d) {
  const bool crosses = side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
  if (crosses) {
    return 0.0;
  }
  return std::min(std::min(squaredDistance(a, c, d), squaredDistance(b, c, d)),
                  std::min(squaredDistance(c, a, b), squaredDistance(d, a, b)));
}

Point2 across(Vec3 p, Axis axis) {
  const int k = lattice::index(axis);
  return {p[(k + 1) % 3], p[(k + 2) % 3]};
}

bool overlapSameAxis(const Stadium& a, const Stadium& b) {
  const int k = lattice::index(a.axis);
  if (std::abs(a.from[k] - b.from[k]) >= 2.0 * kBeamHalfThickness - kContactTolerance) {
    return false;
  }
  const double reach = a.radius + b.radius - kContactTolerance;
  return squaredSegmentDistance(across(a.from, a.axis),
                                across(a.to, a.axis),
                                across(b.from, b.axis),
                                across(b.to, b.axis)) < reach * reach;
}

//! Height of the stadium's upper outline over position s; the outline is the highest of both round
//! ends and of the straight flank between them.
double upperOutline(Point2 a, Point2 b, double radius, double s) {
  double best = -1e30;
  for (const Point2 end : {a, b}) {
    const double d = s - end.u;
    if (d > -radius && d < radius) {
      best = std::max(best, end.v + std::sqrt(radius * radius - d * d));
    }
  }
  const double du = b.u - a.u;
  const double dv = b.v - a.v;
  const double span = std::sqrt(du * du + dv * dv);
  if (span > 0.0 && (du > 1e-12 || du < -1e-12)) {
    const double sign = du > 0.0 ? 1.0 : -1.0;
    const double nu = -dv / span * sign * radius;
    const double nv = du / span * sign * radius;
    const double t = (s - nu - a.u) / du;
    if (t >= 0.0 && t <= 1.0) {
      best = std::max(best, a.v + nv + t * dv);
    }
  }
  return best;
}

//! Highest v that the stadium reaches for u in [low, high]; very low when it does not reach the
//! strip.
double highest(Point2 a, Point2 b, double radius, double low, double high) {
  if (std::max(a.u, b.u) + radius <= low || std::min(a.u, b.u) - radius >= high) {
    return -1e30;
  }
  const Point2 top = a.v >= b.v ? a : b;
  const bool level = a.v == b.v;
  const double topLow = level ? std::min(a.u, b.u) : top.u;
  const double topHigh = level ? std::max(a.u, b.u) : top.u;
  if (topHigh >= low && topLow <= high) {
    return top.v + radius;
  }
  return upperOutline(a, b, radius, topHigh < low ? low : high);
}

bool overlapCrossed(const Stadium& a, const Stadium& b) {
  const int k = lattice::index(a.axis);
  const int j = lattice::index(b.axis);
  const int m = 3 - k - j;
  const double h = kBeamHalfThickness - kContactTolerance;
  const Point2 a0{a.from[j], a.from[m]};
  const Point2 a1{a.to[j], a.to[m]};
  const Point2 b0{b.from[k], b.from[m]};
  const Point2 b1{b.to[k], b.to[m]};
  const auto flipped = [](Point2 p) { return Point2{p.u, -p.v}; };
  const double highA = highest(a0, a1, a.radius, b.from[j] - h, b.from[j] + h);
  const double lowA = -highest(flipped(a0), flipped(a1), a.radius, b.from[j] - h, b.from[j] + h);
  const double highB = highest(b0, b1, b.radius, a.from[k] - h, a.from[k] + h);
  const double lowB = -highest(flipped(b0), flipped(b1), b.radius, a.from[k] - h, a.from[k] + h);
  return std::min(highA, highB) - std::max(lowA, lowB) > kContactTolerance;
}

}  // namespace

bool overlap(const Stadium& a, const Stadium& b) {
  for (int i = 0; i < 3; ++i) {
    if (std::max(std::min(a.from[i], a.to[i]), std::min(b.from[i], b.to[i])) -
            std::min(std::max(a.from[i], a.to[i]), std::max(b.from[i], b.to[i])) >=
        1.0) {
      return false;
    }
  }
  return a.axis == b.axis ? overlapSameAxis(a, b) : overlapCrossed(a, b);
}

double crossDistance(const Stadium& beam, Vec3 point) {
  const int k = lattice::index(beam.axis);
  if (std::abs(beam.from[k] - point[k]) >= 1.0 - kContactTolerance) {
    return 1e9;
  }
  return std::sqrt(squaredDistance(
      across(point, beam.axis), across(beam.from, beam.axis), across(beam.to, beam.axis)));
}

}  // namespace liftarm::layout
