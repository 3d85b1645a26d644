#include "analysis/balance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>

#include "analysis/assembly.h"
#include "base/det_math.h"

namespace liftarm::analysis {

namespace {

using lattice::Vec3;

constexpr double kTiny = 1e-9;

struct Sum {
  double weight = 0.0;
  Vec3 moment;

  void add(double w, Vec3 p) {
    weight += w;
    moment = moment + w * p;
  }
};

void addHoles(const parts::Part& part, Sum& sum) {
  for (const parts::Feature& feature : part.features) {
    for (const Vec3 slot : feature.slots) {
      sum.add(1.0, slot);
    }
  }
}

void addSolids(const parts::Part& part, Sum& sum) {
  for (const parts::Prism& prism : part.solid) {
    const double area = std::numbers::pi * prism.radius * prism.radius +
                        2 * prism.radius * lattice::length(prism.to - prism.from);
    sum.add(2 * prism.halfThickness * area, 0.5 * (prism.from + prism.to));
  }
  for (const parts::Feature& feature : part.features) {
    if (parts::isMale(feature.kind)) {
      sum.add(std::numbers::pi * kHeadRadius * kHeadRadius * feature.length, feature.center);
    }
  }
}

double degrees(double radians) {
  return radians * 180.0 / std::numbers::pi;
}

//! A side of the polygon as seen from the centre of mass.
struct Side {
  double distance = 1e9;  // of the centre inwards
  GroundPoint outwards;
};

//! The side that is nearest; sides of a polygon run counter-clockwise.
Side nearestSide(const std::vector<GroundPoint>& polygon, GroundPoint p) {
  Side nearest;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const GroundPoint a = polygon[i];
    const GroundPoint b = polygon[(i + 1) % polygon.size()];
    const double length = std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
    const GroundPoint out{(b.y - a.y) / length, -(b.x - a.x) / length};
    const double distance = (a.x - p.x) * out.x + (a.y - p.y) * out.y;
    if (distance < nearest.distance - kTiny) {
      nearest = {distance, out};
    }
  }
  return nearest;
}

//! The point of the polygon that is nearest to a point outside.
GroundPoint nearestPoint(const std::vector<GroundPoint>& polygon, GroundPoint p) {
  GroundPoint best = polygon.front();
  double bestSquare = 1e18;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const GroundPoint a = polygon[i];
    const GroundPoint b = polygon[(i + 1) % polygon.size()];
    const double square = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
    const double along =
        square > kTiny ? ((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / square : 0.0;
    const double t = std::clamp(along, 0.0, 1.0);
    const GroundPoint q{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
    const double away = (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y);
    if (away < bestSquare) {
      bestSquare = away;
      best = q;
    }
  }
  return best;
}

void judge(Balance& balance) {
  const GroundPoint centre{balance.centre.x, balance.centre.y};
  const double height = std::max(balance.centre.z - balance.ground, kTiny);
  if (balance.polygon.size() >= 3) {
    const Side side = nearestSide(balance.polygon, centre);
    if (side.distance > kTiny) {
      balance.stable = true;
      balance.margin = side.distance;
      balance.direction = side.outwards;
      balance.tippingAngle = degrees(base::detAtan2(side.distance, height));
      return;
    }
  }
  const GroundPoint nearest = nearestPoint(balance.polygon, centre);
  const GroundPoint away{centre.x - nearest.x, centre.y - nearest.y};
  const double distance = std::sqrt(away.x * away.x + away.y * away.y);
  balance.margin = -distance;
  if (distance > kTiny) {
    balance.direction = {away.x / distance, away.y / distance};
  } else if (balance.polygon.size() == 2) {
    // On a knife's edge: across it.
    const double x = balance.polygon[1].x - balance.polygon[0].x;
    const double y = balance.polygon[1].y - balance.polygon[0].y;
    const double length = std::sqrt(x * x + y * y);
    balance.direction = {y / length, -x / length};
  } else if (balance.polygon.size() >= 3) {
    balance.direction = nearestSide(balance.polygon, centre).outwards;
  }
}

}  // namespace

Vec3 centreOfMass(const parts::Part& part) {
  Sum sum;
  if (part.partClass == parts::PartClass::kBeam) {
    addHoles(part, sum);
  } else {
    addSolids(part, sum);
  }
  return sum.weight > 0.0 ? (1.0 / sum.weight) * sum.moment
                          : 0.5 * (part.boundsMin + part.boundsMax);
}

std::optional<Balance> balanceOf(const Scene& scene, const std::vector<int>& parts) {
  Sum sum;
  std::vector<int> known;
  for (const int i : parts) {
    const auto index = static_cast<std::size_t>(i);
    const parts::Part* part = scene.parts[index].part;
    if (part != nullptr && !scene.parts[index].shapes.empty()) {
      known.push_back(i);
      sum.add(part->mass, scene.model->parts[index].pose.apply(centreOfMass(*part)));
    }
  }
  if (known.empty() || sum.weight <= 0.0) {
    return std::nullopt;
  }
  Balance balance;
  balance.mass = sum.weight;
  balance.centre = (1.0 / sum.weight) * sum.moment;
  balance.ground = lowestPoint(scene, known);
  balance.polygon = convexHull(touchingPoints(scene, known, balance.ground));
  judge(balance);
  return balance;
}

std::optional<Balance> checkBalance(const Scene& scene) {
  std::map<int, std::vector<int>> parts;
  const std::vector<int> assemblies = findAssemblies(scene);
  for (std::size_t i = 0; i < assemblies.size(); ++i) {
    if (assemblies[i] >= 0 || assemblies.size() == 1) {
      parts[assemblies[i]].push_back(static_cast<int>(i));
    }
  }
  std::optional<Balance> worst;
  for (const auto& [assembly, members] : parts) {
    const std::optional<Balance> balance = balanceOf(scene, members);
    if (balance.has_value() && (!worst.has_value() || balance->margin < worst->margin)) {
      worst = balance;
    }
  }
  return worst;
}

}  // namespace liftarm::analysis
