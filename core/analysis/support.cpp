#include "analysis/support.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "analysis/convex.h"
#include "base/det_math.h"

namespace liftarm::analysis {

namespace {

using lattice::Vec3;
using parts::Prism;

constexpr int kRimPoints = 16;
constexpr double kCollinear = 1e-9;

const ScenePart& partAt(const Scene& scene, int i) {
  return scene.parts[static_cast<std::size_t>(i)];
}

//! Unit vector across the axis that points down as far as it can; any where the axis is vertical.
Vec3 downAcross(Vec3 axis) {
  const Vec3 down = Vec3{0, 0, -1} - (-axis.z) * axis;
  const double length = lattice::length(down);
  constexpr double kVertical = 1e-9;
  return length > kVertical ? (1.0 / length) * down : Vec3{1, 0, 0};
}

void addTouching(const Prism& prism, double top, std::vector<GroundPoint>& points) {
  const Vec3 first = downAcross(prism.axis);
  const Vec3 second = lattice::cross(prism.axis, first);
  for (const Vec3 end : {prism.from, prism.to}) {
    for (const double side : {-1.0, 1.0}) {
      for (int k = 0; k < kRimPoints; ++k) {
        const double angle = 2 * std::numbers::pi * k / kRimPoints;
        const Vec3 p = end + (side * prism.halfThickness) * prism.axis +
                       (prism.radius * base::detCos(angle)) * first +
                       (prism.radius * base::detSin(angle)) * second;
        if (p.z <= top) {
          points.push_back({p.x, p.y});
        }
      }
    }
  }
}

double turn(GroundPoint a, GroundPoint b, GroundPoint c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace

double lowestPoint(const Scene& scene, const std::vector<int>& parts) {
  double lowest = 1e9;
  for (const int i : parts) {
    for (const Shape& shape : partAt(scene, i).shapes) {
      lowest = std::min(lowest, boundsOf(shape.prism).min.z);
    }
  }
  return lowest;
}

std::vector<GroundPoint> touchingPoints(const Scene& scene,
                                        const std::vector<int>& parts,
                                        double ground) {
  std::vector<GroundPoint> points;
  for (const int i : parts) {
    for (const Shape& shape : partAt(scene, i).shapes) {
      if (boundsOf(shape.prism).min.z <= ground + kTouch) {
        addTouching(shape.prism, ground + kTouch, points);
      }
    }
  }
  return points;
}

std::vector<GroundPoint> convexHull(std::vector<GroundPoint> points) {
  const auto less = [](GroundPoint a, GroundPoint b) {
    return std::pair(a.x, a.y) < std::pair(b.x, b.y);
  };
  std::sort(points.begin(), points.end(), less);
  points.erase(
      std::unique(points.begin(),
                  points.end(),
                  [&](GroundPoint a, GroundPoint b) { return !less(a, b) && !less(b, a); }),
      points.end());
  if (points.size() < 3) {
    return points;
  }
  // Andrew's chains: the lower one from left to right, the upper one back.
  std::vector<GroundPoint> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t start = hull.size();
    for (const GroundPoint p : points) {
      while (hull.size() >= start + 2 &&
             turn(hull[hull.size() - 2], hull.back(), p) <= kCollinear) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

}  // namespace liftarm::analysis
