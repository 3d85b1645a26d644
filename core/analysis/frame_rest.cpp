#include "analysis/frame_rest.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

#include "base/det_math.h"

namespace liftarm::analysis {

namespace {

using lattice::Vec3;

constexpr double kDegrees = 57.29577951308232;
constexpr int kMaxRolls = 50;
constexpr double kLiesFlat = 0.999;  // cosine: a face that lies on the table
constexpr double kSamePoint = 1e-6;  // modules

//! A point of the surface, and whether it counts where its face lies flat: four of eight do.
struct SurfacePoint {
  Foot point;
  Vec3 axis;
  bool corner = true;
};

Vec3 squareTo(Vec3 axis) {
  return lattice::normalized(std::abs(axis.x) < 0.9 ? lattice::cross(axis, {1, 0, 0})
                                                    : lattice::cross(axis, {0, 1, 0}));
}

//! Points around both ends of a prism, its lowest ones among them.
void addPoints(const parts::Prism& prism, int part, std::vector<SurfacePoint>& points) {
  const double diagonal = std::sqrt(0.5);
  const bool straight = lattice::length(prism.to - prism.from) > kSamePoint;
  const Vec3 u = straight ? lattice::normalized(prism.to - prism.from) : squareTo(prism.axis);
  const Vec3 v = lattice::cross(prism.axis, u);
  const Vec3 down = prism.axis.z * prism.axis - Vec3{0, 0, 1};
  std::vector<std::pair<Vec3, bool>> ways{{u, true}, {-u, true}, {v, true}, {-v, true}};
  for (const double a : {-diagonal, diagonal}) {
    ways.push_back({a * u + diagonal * v, false});
    ways.push_back({a * u - diagonal * v, false});
  }
  if (lattice::length(down) > 1.0 - kLiesFlat) {
    ways.push_back({lattice::normalized(down), false});
  }
  for (const Vec3 end : {prism.from, prism.to}) {
    for (const auto& [way, corner] : ways) {
      for (const double side : {-prism.halfThickness, prism.halfThickness}) {
        points.push_back(
            {{part, end + prism.radius * way + side * prism.axis}, prism.axis, corner});
      }
    }
    if (!straight) {
      break;
    }
  }
}

std::vector<SurfacePoint> surfaceOf(const Scene& scene) {
  std::set<std::tuple<int, int, int>> inHoles;
  for (const model::Connection& c : scene.connections) {
    inHoles.insert({c.male, c.maleFeature, c.maleSlot});
  }
  std::vector<SurfacePoint> points;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const int part = static_cast<int>(i);
    for (const Shape& shape : scene.parts[i].shapes) {
      const bool free =
          shape.kind == Shape::Kind::kHead && inHoles.count({part, shape.feature, shape.slot}) == 0;
      if (shape.kind == Shape::Kind::kBody || free) {
        addPoints(shape.prism, part, points);
      }
    }
  }
  return points;
}

//! \param all Every point that touches; otherwise flat faces give their corners only.
std::vector<Foot> feetOf(const std::vector<SurfacePoint>& surface, Vec3 up, bool all) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const SurfacePoint& s : surface) {
    lowest = std::min(lowest, lattice::dot(s.point.at, up));
  }
  std::vector<Foot> feet;
  for (const SurfacePoint& s : surface) {
    const bool flat = !all && std::abs(lattice::dot(s.axis, up)) > kLiesFlat;
    if (lattice::dot(s.point.at, up) > lowest + kRestTolerance || (flat && !s.corner)) {
      continue;
    }
    const auto isSame = [&](const Foot& other) {
      return other.part == s.point.part && lattice::length(other.at - s.point.at) < kSamePoint;
    };
    if (std::none_of(feet.begin(), feet.end(), isSame)) {
      feet.push_back(s.point);
    }
  }
  return feet;
}

//! The point of a segment nearest to p, as seen along `up`.
Vec3 nearestOn(Vec3 a, Vec3 b, Vec3 p, Vec3 up) {
  const auto flat = [&](Vec3 v) { return v - lattice::dot(v, up) * up; };
  const Vec3 along = flat(b - a);
  const double square = lattice::dot(along, along);
  const double t = square > 0.0 ? lattice::dot(flat(p - a), along) / square : 0.0;
  return a + std::clamp(t, 0.0, 1.0) * (b - a);
}

//! Feet on the rim of their convex hull, in order around it (Andrew's monotone chain).
std::vector<Vec3> hullOf(const std::vector<Foot>& feet, Vec3 up) {
  const Vec3 e1 = squareTo(up);
  const Vec3 e2 = lattice::cross(up, e1);
  std::vector<std::tuple<double, double, Vec3>> flat;
  for (const Foot& foot : feet) {
    flat.emplace_back(lattice::dot(foot.at, e1), lattice::dot(foot.at, e2), foot.at);
  }
  std::sort(flat.begin(), flat.end(), [](const auto& a, const auto& b) {
    return std::pair{std::get<0>(a), std::get<1>(a)} < std::pair{std::get<0>(b), std::get<1>(b)};
  });
  std::vector<Vec3> hull;
  for (int half = 0; half < 2; ++half) {
    const std::size_t start = hull.size();
    for (const auto& [x, y, at] : flat) {
      while (hull.size() >= start + 2 &&
             lattice::dot(lattice::cross(hull.back() - hull[hull.size() - 2], at - hull.back()),
                          up) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(at);
    }
    hull.pop_back();
    std::reverse(flat.begin(), flat.end());
  }
  return hull.empty() ? std::vector<Vec3>{feet.front().at} : hull;
}

//! The place over the feet's hull nearest to the centre; the centre itself where it is above them.
Vec3 nearestSupport(const std::vector<Vec3>& hull, Vec3 centre, Vec3 up) {
  bool inside = hull.size() >= 3;
  Vec3 best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec3 a = hull[i];
    const Vec3 b = hull[(i + 1) % hull.size()];
    inside = inside && lattice::dot(lattice::cross(b - a, centre - a), up) >= 0.0;
    const Vec3 near = nearestOn(a, b, centre, up);
    const Vec3 apart = centre - near;
    const double distance = lattice::length(apart - lattice::dot(apart, up) * up);
    if (distance < least) {
      least = distance;
      best = near;
    }
  }
  return inside ? centre : best;
}

//! Rolls about `pivot` towards `way` until the next point touches. \return The new up.
Vec3 roll(const std::vector<SurfacePoint>& surface, Vec3 pivot, Vec3 way, Vec3 up) {
  double least = std::numeric_limits<double>::infinity();
  for (const SurfacePoint& s : surface) {
    const double x = lattice::dot(s.point.at - pivot, way);
    const double z = std::max(0.0, lattice::dot(s.point.at - pivot, up));
    if (x > kRestTolerance || z > kRestTolerance) {
      least = std::min(least, base::detAtan2(z, x));
    }
  }
  return lattice::normalized(base::detCos(least) * up - base::detSin(least) * way);
}

}  // namespace

Rest findRest(const Scene& scene, Vec3 centre) {
  const std::vector<SurfacePoint> surface = surfaceOf(scene);
  Rest rest;
  if (surface.empty()) {
    return rest;
  }
  for (int round = 0; round < kMaxRolls; ++round) {
    const std::vector<Foot> touching = feetOf(surface, rest.up, true);
    const Vec3 pivot = nearestSupport(hullOf(touching, rest.up), centre, rest.up);
    Vec3 way = centre - pivot;
    way = way - lattice::dot(way, rest.up) * rest.up;
    if (lattice::length(way) < kSamePoint) {
      break;
    }
    rest.up = roll(surface, pivot, lattice::normalized(way), rest.up);
  }
  rest.feet = feetOf(surface, rest.up, false);
  rest.tilt = kDegrees *
              base::detAtan2(std::sqrt(rest.up.x * rest.up.x + rest.up.y * rest.up.y), rest.up.z);
  return rest;
}

}  // namespace liftarm::analysis
