#include "analysis/convex.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace liftarm::analysis {

namespace {

using lattice::Vec3;
using parts::Prism;

constexpr int kMaxSteps = 64;
constexpr double kTinySquare = 1e-12;
constexpr double kAlongAxis = 1e-10;  // radians: nearer to the axis is along it
constexpr double kNoHeight = 1e-9;    // modules: lower tetrahedra have no inside

//! The point of a prism that lies furthest along d, the prism drawn in by `inset`.
struct PrismSupport {
  const Prism& prism;
  double inset;

  Vec3 operator()(Vec3 d) const {
    const double along = lattice::dot(d, prism.axis);
    // Twice, so that nothing along the axis is left where d hardly leaves it: axes of poses that a
    // file has rounded are of unit length to nine decimals only.
    const Vec3 rough = d - along * prism.axis;
    const Vec3 across = rough - lattice::dot(rough, prism.axis) * prism.axis;
    const double norm = lattice::length(across);
    Vec3 p = lattice::dot(d, prism.to - prism.from) > 0.0 ? prism.to : prism.from;
    if (norm > kAlongAxis * lattice::length(d)) {
      p = p + ((prism.radius - inset) / norm) * across;
    }
    const double height = prism.halfThickness - inset;
    return p + (along >= 0.0 ? height : -height) * prism.axis;
  }
};

//! The same for all places of a prism on a straight way.
struct MovedPrismSupport {
  PrismSupport prism;
  Vec3 travel;

  Vec3 operator()(Vec3 d) const {
    const Vec3 p = prism(d);
    return lattice::dot(d, travel) > 0.0 ? p + travel : p;
  }
};

struct BoxSupport {
  const Box& box;
  double inset;

  Vec3 operator()(Vec3 d) const {
    Vec3 p;
    for (int i = 0; i < 3; ++i) {
      p[i] = d[i] >= 0.0 ? box.max[i] - inset : box.min[i] + inset;
    }
    return p;
  }
};

//! Up to four points of the Minkowski difference, and the point of their hull nearest to the
//! origin.
struct Simplex {
  std::array<Vec3, 4> points;
  std::size_t size = 0;
  Vec3 nearest;
  double square = 1e30;  // of |nearest|
};

void offer(Simplex& best, const Simplex& other) {
  if (other.square < best.square) {
    best = other;
  }
}

Simplex nearestOnPoint(Vec3 a) {
  Simplex s;
  s.points[0] = a;
  s.size = 1;
  s.nearest = a;
  s.square = lattice::dot(a, a);
  return s;
}

Simplex nearestOnSegment(Vec3 a, Vec3 b) {
  const Vec3 ab = b - a;
  const double t = -lattice::dot(a, ab);
  const double whole = lattice::dot(ab, ab);
  if (t <= 0.0 || whole <= kTinySquare) {
    return nearestOnPoint(a);
  }
  if (t >= whole) {
    return nearestOnPoint(b);
  }
  Simplex s = nearestOnPoint(a + (t / whole) * ab);
  s.points = {a, b};
  s.size = 2;
  return s;
}

Simplex nearestOnTriangle(Vec3 a, Vec3 b, Vec3 c) {
  Simplex best = nearestOnSegment(a, b);
  offer(best, nearestOnSegment(b, c));
  offer(best, nearestOnSegment(c, a));
  const Vec3 normal = lattice::cross(b - a, c - a);
  const double square = lattice::dot(normal, normal);
  if (square <= kTinySquare * kTinySquare) {
    return best;
  }
  const bool inside = lattice::dot(lattice::cross(b - a, -a), normal) >= 0.0 &&
                      lattice::dot(lattice::cross(c - b, -b), normal) >= 0.0 &&
                      lattice::dot(lattice::cross(a - c, -c), normal) >= 0.0;
  if (inside) {
    Simplex face = nearestOnPoint((lattice::dot(a, normal) / square) * normal);
    face.points = {a, b, c};
    face.size = 3;
    offer(best, face);
  }
  return best;
}

//! False where the origin surely lies on the same side of face abc as d. A flat tetrahedron has no
//! inside: faces that lie in one plane give such ones, and rounding alone would put the origin in.
bool outside(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Vec3 normal = lattice::cross(b - a, c - a);
  const double height = lattice::dot(d - a, normal);
  const bool flat = height * height <= kNoHeight * kNoHeight * lattice::dot(normal, normal);
  return flat || lattice::dot(-a, normal) * height < 0.0;
}

//! The nearest point of the hull; size 4 means that the origin is inside.
Simplex nearestOnTetrahedron(const std::array<Vec3, 4>& p) {
  Simplex best;
  bool inside = true;
  constexpr std::array<std::array<std::size_t, 4>, 4> kFaces{
      {{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 3, 1}, {1, 2, 3, 0}}};
  for (const auto& f : kFaces) {
    if (outside(p[f[0]], p[f[1]], p[f[2]], p[f[3]])) {
      inside = false;
      offer(best, nearestOnTriangle(p[f[0]], p[f[1]], p[f[2]]));
    }
  }
  if (inside) {
    best.size = 4;
    best.square = 0.0;
  }
  return best;
}

Simplex extended(const Simplex& s, Vec3 w) {
  switch (s.size) {
    case 1:
      return nearestOnSegment(s.points[0], w);
    case 2:
      return nearestOnTriangle(s.points[0], s.points[1], w);
    default:
      return nearestOnTetrahedron({s.points[0], s.points[1], s.points[2], w});
  }
}

template <typename SupportA, typename SupportB>
bool intersect(const SupportA& a, const SupportB& b, Vec3 start) {
  const auto support = [&](Vec3 d) { return a(d) - b(-d); };
  Simplex simplex = nearestOnPoint(support(start));
  for (int step = 0; step < kMaxSteps; ++step) {
    if (simplex.size == 4 || simplex.square <= kTinySquare) {
      return true;
    }
    const Vec3 w = support(-simplex.nearest);
    if (lattice::dot(w, simplex.nearest) > 0.0) {
      return false;  // a plane parts the two
    }
    simplex = extended(simplex, w);
  }
  return false;  // however near, no point of both was found
}

}  // namespace

Box boundsOf(const Prism& prism) {
  Box box;
  for (int i = 0; i < 3; ++i) {
    const double a = prism.axis[i];
    const double reach =
        prism.radius * std::sqrt(std::max(0.0, 1.0 - a * a)) + prism.halfThickness * std::abs(a);
    box.min[i] = std::min(prism.from[i], prism.to[i]) - reach;
    box.max[i] = std::max(prism.from[i], prism.to[i]) + reach;
  }
  return box;
}

bool overlap(const Prism& a, const Prism& b, double tolerance) {
  if (!meet(boundsOf(a), boundsOf(b), tolerance)) {
    return false;
  }
  return intersect(PrismSupport{a, tolerance / 2}, PrismSupport{b, tolerance / 2}, b.from - a.from);
}

bool overlapOnTheWay(const Prism& a, Vec3 travel, const Prism& b, double tolerance) {
  return intersect(MovedPrismSupport{{a, tolerance / 2}, travel},
                   PrismSupport{b, tolerance / 2},
                   b.from - a.from);
}

bool overlap(const Prism& a, const Box& box, double tolerance) {
  if (!meet(boundsOf(a), box, tolerance)) {
    return false;
  }
  return intersect(PrismSupport{a, tolerance / 2},
                   BoxSupport{box, tolerance / 2},
                   0.5 * (box.min + box.max) - a.from);
}

}  // namespace liftarm::analysis
