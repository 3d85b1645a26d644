#include "analysis/sweep.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "analysis/convex.h"
#include "analysis/interpenetration.h"

namespace liftarm::analysis {

namespace {

using lattice::Vec3;
using Kind = Shape::Kind;
using parts::FeatureKind;
using parts::Prism;

Prism moved(Prism prism, Vec3 by) {
  prism.from = prism.from + by;
  prism.to = prism.to + by;
  return prism;
}

//! The box of all that a box passes.
Box swept(const Box& box, const Path& path) {
  Box result;
  const Vec3 end = path.start + path.distance * path.direction;
  result.add({box.min + path.start, box.max + path.start});
  result.add({box.min + end, box.max + end});
  return result;
}

Path reversed(const Path& path) {
  return {-path.direction, path.distance, -path.start};
}

bool parallel(Vec3 a, Vec3 b) {
  return std::abs(lattice::dot(a, b)) >= model::kCoaxialCosine;
}

bool crossesAgree(Vec3 a, Vec3 b) {
  constexpr double kSine = 0.035;  // 2 degrees
  return std::min(std::abs(lattice::dot(a, b)), lattice::length(lattice::cross(a, b))) <= kSine;
}

//! A stretch of a line, by distances from a point on it.
using Interval = std::pair<double, double>;

//! What is left of a stretch without the given ones.
std::vector<Interval> without(Interval whole, std::vector<Interval> cuts) {
  std::sort(cuts.begin(), cuts.end());
  std::vector<Interval> rest;
  double at = whole.first;
  for (const Interval& cut : cuts) {
    if (cut.first > at) {
      rest.emplace_back(at, std::min(cut.first, whole.second));
    }
    at = std::max(at, cut.second);
    if (at >= whole.second) {
      return rest;
    }
  }
  rest.emplace_back(at, whole.second);
  return rest;
}

}  // namespace

Sweep::Body Sweep::makeBody(const model::PlacedPart& source, const ScenePart& part) {
  Body body;
  if (part.part == nullptr) {
    return body;
  }
  body.gear = part.part->partClass == parts::PartClass::kGear;
  for (const Shape& shape : part.shapes) {
    if (shape.kind != Kind::kHead) {
      body.solids.push_back({shape.kind, shape.prism, boundsOf(shape.prism), {}, {}});
    }
  }
  for (const parts::Feature& feature : part.part->features) {
    const Vec3 axis = source.pose.rotation * feature.axis;
    const Vec3 center = source.pose.apply(feature.center);
    const Vec3 wing = source.pose.rotation * feature.wing.value_or(Vec3{});
    if (parts::isMale(feature.kind)) {
      const Prism rod{center, center, axis, kHeadRadius, feature.length / 2};
      body.solids.push_back({Kind::kHead, rod, boundsOf(rod), feature.kind, wing});
    } else {
      body.holes.push_back({feature.kind, center, axis, feature.length / 2, wing});
    }
  }
  return body;
}

Sweep::Sweep(const Scene& scene) {
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    bodies_.push_back(makeBody(scene.model->parts[i], scene.parts[i]));
  }
}

bool Sweep::hits(const Solid& mover, const Solid& fixed, const Path& path, double tolerance) {
  return overlapOnTheWay(
      moved(mover.prism, path.start), path.distance * path.direction, fixed.prism, tolerance);
}

//! A head or collar that moves along its axis past a wall: true where it does not find holes, or
//! rims, all the way. What lies between them is tested as one rod.
bool Sweep::passesNot(const Solid& head, const Body& other, const Solid& wall, const Path& path) {
  const Vec3 origin = head.prism.from + path.start;
  std::vector<Interval> open;
  for (const Hole& hole : other.holes) {
    if (!parallel(hole.axis, path.direction)) {
      continue;
    }
    const Vec3 offset = hole.center - origin;
    const double at = lattice::dot(offset, path.direction);
    if (lattice::length(offset - at * path.direction) > model::kCoaxialDistance) {
      continue;
    }
    if (head.kind == Kind::kCollar) {
      if (hole.kind == FeatureKind::kPinHole) {
        const double rim = kCounterbore + kPenetration;
        open.emplace_back(at - hole.halfLength - rim, at - hole.halfLength + rim);
        open.emplace_back(at + hole.halfLength - rim, at + hole.halfLength + rim);
      }
      continue;
    }
    const bool fits = hole.kind == FeatureKind::kPinHole ||
                      (head.head == FeatureKind::kAxle && crossesAgree(head.wing, hole.wing));
    if (fits) {
      open.emplace_back(at - hole.halfLength, at + hole.halfLength);
    }
  }
  if (open.empty()) {
    return hits(head, wall, path, kPenetration);
  }
  const double half = head.prism.halfThickness;
  for (const Interval& piece : without({-half, path.distance + half}, std::move(open))) {
    const double length = piece.second - piece.first;
    if (length <= kPenetration) {
      continue;
    }
    const Vec3 middle = origin + ((piece.first + piece.second) / 2) * path.direction;
    if (overlap({middle, middle, head.prism.axis, head.prism.radius, length / 2},
                wall.prism,
                kPenetration)) {
      return true;
    }
  }
  return false;
}

bool Sweep::solidsMeet(
    const Body& mover, const Solid& s, const Body& fixed, const Solid& t, const Path& path) {
  // The necks of a connector reach into its own holes: they are walls for heads as its body is.
  const auto isWall = [](const Solid& head, const Solid& other) {
    return other.kind == Kind::kBody || (other.kind == Kind::kCollar && head.kind == Kind::kHead);
  };
  if (s.kind != Kind::kBody && isWall(s, t) && parallel(s.prism.axis, path.direction)) {
    return passesNot(s, fixed, t, path);
  }
  if (t.kind != Kind::kBody && isWall(t, s) && parallel(t.prism.axis, path.direction)) {
    return passesNot(t, mover, s, reversed(path));
  }
  const double teeth = mover.gear && fixed.gear ? 2 * kToothHeight : 0.0;
  return hits(s, t, path, kPenetration + teeth);
}

bool Sweep::blocks(int mover, int fixed, const Path& path) const {
  const Body& a = bodies_[static_cast<std::size_t>(mover)];
  const Body& b = bodies_[static_cast<std::size_t>(fixed)];
  for (const Solid& s : a.solids) {
    const Box way = swept(s.box, path);
    for (const Solid& t : b.solids) {
      if (meet(way, t.box, kPenetration) && solidsMeet(a, s, b, t, path)) {
        return true;
      }
    }
  }
  return false;
}

bool Sweep::overlapInPlace(int a, int b) const {
  const Body& first = bodies_[static_cast<std::size_t>(a)];
  const Body& second = bodies_[static_cast<std::size_t>(b)];
  for (const Solid& s : first.solids) {
    for (const Solid& t : second.solids) {
      // Not a move, but a way along the head's axis: in its hole it meets nothing.
      const Path stay{
          s.kind == Kind::kHead || t.kind == Kind::kBody ? s.prism.axis : t.prism.axis, 0.0, {}};
      if (meet(s.box, t.box, kPenetration) && solidsMeet(first, s, second, t, stay)) {
        return true;
      }
    }
  }
  return false;
}

Sweep::Extent Sweep::extent(int part, Vec3 along) const {
  Extent extent;
  for (const Solid& solid : bodies_[static_cast<std::size_t>(part)].solids) {
    const Prism& p = solid.prism;
    const double a = lattice::dot(p.axis, along);
    const double reach =
        p.radius * std::sqrt(std::max(0.0, 1.0 - a * a)) + p.halfThickness * std::abs(a);
    const double from = lattice::dot(p.from, along);
    const double to = lattice::dot(p.to, along);
    extent.min = std::min(extent.min, std::min(from, to) - reach);
    extent.max = std::max(extent.max, std::max(from, to) + reach);
  }
  return extent;
}

}  // namespace liftarm::analysis
