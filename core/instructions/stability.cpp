#include "instructions/stability.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace liftarm::instructions {

namespace {

using analysis::Scene;
using lattice::Vec3;
using parts::Prism;

constexpr double kMargin = 0.1;  // modules inside the edge, so that a rounded end does not stand
constexpr double kLean = 1.0;    // modules that parts may tilt by when they lie on another side

struct Point {
  double x = 0.0;
  double y = 0.0;
};

double turn(Point a, Point b, Point c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

//! The corners of the convex hull against the clock.
std::vector<Point> hullOf(std::vector<Point> points) {
  std::sort(points.begin(), points.end(), [](Point a, Point b) {
    return std::pair(a.x, a.y) < std::pair(b.x, b.y);
  });
  std::vector<Point> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t start = hull.size();
    for (const Point p : points) {
      while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();  // the last point begins the other side
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

bool inside(Point p, const std::vector<Point>& hull) {
  if (hull.size() < 3) {
    return false;
  }
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point a = hull[i];
    const Point b = hull[(i + 1) % hull.size()];
    const double edge = std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
    if (turn(a, b, p) < kMargin * edge) {
      return false;
    }
  }
  return true;
}

//! The point of a prism that lies furthest along d.
Vec3 furthest(const Prism& prism, Vec3 d) {
  const double along = lattice::dot(d, prism.axis);
  const Vec3 across = d - along * prism.axis;
  const double norm = lattice::length(across);
  Vec3 p = lattice::dot(d, prism.to - prism.from) > 0.0 ? prism.to : prism.from;
  if (norm > 1e-12) {
    p = p + (prism.radius / norm) * across;
  }
  return p + (along >= 0.0 ? prism.halfThickness : -prism.halfThickness) * prism.axis;
}

// Tilted a little each way, the lowest points of a solid are the corners of its underside.
constexpr double kTilt = 1e-3;
constexpr std::array<Point, 8> kWays{
    {{1, 0}, {0.7, 0.7}, {0, 1}, {-0.7, 0.7}, {-1, 0}, {-0.7, -0.7}, {0, -1}, {0.7, -0.7}}};

//! The level of the table under some parts.
double floorOf(const Scene& scene, const std::vector<int>& parts, Vec3 up) {
  double floor = 1e9;
  for (const int part : parts) {
    for (const analysis::Shape& shape : scene.parts[static_cast<std::size_t>(part)].shapes) {
      floor = std::min(floor, lattice::dot(furthest(shape.prism, -up), up));
    }
  }
  return floor;
}

}  // namespace

bool standsOn(const Scene& scene, const std::vector<int>& parts, Vec3 up, double lean) {
  const Vec3 helper = up.z * up.z > 0.5 ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
  const Vec3 u = lattice::normalized(lattice::cross(up, helper));
  const Vec3 v = lattice::cross(up, u);
  const auto flat = [&](Vec3 p) { return Point{lattice::dot(p, u), lattice::dot(p, v)}; };
  const double floor = floorOf(scene, parts, up);
  std::vector<Point> touching;
  Vec3 moment;
  double mass = 0.0;
  for (const int index : parts) {
    const auto i = static_cast<std::size_t>(index);
    const parts::Part& part = *scene.parts[i].part;
    mass += part.mass;
    moment = moment +
             part.mass * scene.model->parts[i].pose.apply(0.5 * (part.boundsMin + part.boundsMax));
    for (const analysis::Shape& shape : scene.parts[i].shapes) {
      if (lattice::dot(furthest(shape.prism, -up), up) >= floor + lean) {
        continue;  // none of its points is lower
      }
      for (const Point way : kWays) {
        const Vec3 p = furthest(shape.prism, kTilt * way.x * u + kTilt * way.y * v - up);
        if (lattice::dot(p, up) < floor + lean) {
          touching.push_back(flat(p));
        }
      }
    }
  }
  return mass > 0.0 && inside(flat((1.0 / mass) * moment), hullOf(std::move(touching)));
}

bool standTogether(const Scene& scene,
                   const std::vector<std::vector<int>>& sets,
                   Vec3 up,
                   double lean) {
  double lowest = 1e9;
  double highest = -1e9;
  for (const std::vector<int>& set : sets) {
    const double floor = floorOf(scene, set, up);
    lowest = std::min(lowest, floor);
    highest = std::max(highest, floor);
  }
  return highest - lowest <= lean &&
         std::all_of(sets.begin(), sets.end(), [&](const std::vector<int>& set) {
           return standsOn(scene, set, up, lean);
         });
}

bool standAnyway(const Scene& scene, const std::vector<std::vector<int>>& sets) {
  constexpr std::array<Vec3, 5> kSides{{{0, 0, -1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}}};
  return standTogether(scene, sets, {0, 0, 1}) ||
         std::any_of(kSides.begin(), kSides.end(), [&](Vec3 up) {
           return standTogether(scene, sets, up, kLean);
         });
}

bool canBeLaidDown(const Scene& scene, const std::vector<int>& parts) {
  const auto onSideOf = [&](const analysis::Shape& shape) {
    const Vec3 length = shape.prism.to - shape.prism.from;
    if (lattice::length(length) < 1.0) {
      return false;  // as good as round
    }
    const Vec3 across = lattice::normalized(lattice::cross(shape.prism.axis, length));
    return standsOn(scene, parts, across, kLean) || standsOn(scene, parts, -across, kLean);
  };
  return standAnyway(scene, {parts}) || std::any_of(parts.begin(), parts.end(), [&](int part) {
           const auto& shapes = scene.parts[static_cast<std::size_t>(part)].shapes;
           return std::any_of(shapes.begin(), shapes.end(), onSideOf);
         });
}

Footing::Footing(const Scene& scene) {
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    Foot foot;
    for (const analysis::Shape& shape : scene.parts[i].shapes) {
      for (const Point way : kWays) {
        foot.points.push_back(furthest(shape.prism, {kTilt * way.x, kTilt * way.y, -1.0}));
        foot.floor = std::min(foot.floor, foot.points.back().z);
      }
    }
    foot.points.erase(std::remove_if(foot.points.begin(),
                                     foot.points.end(),
                                     [&](Vec3 p) { return p.z > foot.floor + kTouch; }),
                      foot.points.end());
    if (const parts::Part* part = scene.parts[i].part; part != nullptr) {
      foot.mass = part->mass;
      foot.moment =
          part->mass * scene.model->parts[i].pose.apply(0.5 * (part->boundsMin + part->boundsMax));
    }
    feet_.push_back(std::move(foot));
  }
}

bool Footing::stands(const std::vector<int>& parts) const {
  double floor = 1e9;
  double mass = 0.0;
  Vec3 moment;
  for (const int part : parts) {
    const Foot& foot = feet_[static_cast<std::size_t>(part)];
    floor = std::min(floor, foot.floor);
    mass += foot.mass;
    moment = moment + foot.moment;
  }
  std::vector<Point> touching;
  for (const int part : parts) {
    const Foot& foot = feet_[static_cast<std::size_t>(part)];
    if (foot.floor < floor + kTouch) {
      for (const Vec3 p : foot.points) {
        touching.push_back({p.x, p.y});
      }
    }
  }
  return mass > 0.0 && inside({moment.x / mass, moment.y / mass}, hullOf(std::move(touching)));
}

}  // namespace liftarm::instructions
