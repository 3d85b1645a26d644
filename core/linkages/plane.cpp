#include "linkages/plane.h"

#include <algorithm>

namespace liftarm::linkages {

Point nearestOn(Point p, Point from, Point to) {
  const Point span = to - from;
  const double square = dot(span, span);
  const double share = square > 0.0 ? std::clamp(dot(p - from, span) / square, 0.0, 1.0) : 0.0;
  return from + share * span;
}

double distanceBetween(Point a, Point b, Point c, Point d) {
  if (cross(b - a, c - a) * cross(b - a, d - a) < 0.0 &&
      cross(d - c, a - c) * cross(d - c, b - c) < 0.0) {
    return 0.0;
  }
  return std::min({length(a - nearestOn(a, c, d)),
                   length(b - nearestOn(b, c, d)),
                   length(c - nearestOn(c, a, b)),
                   length(d - nearestOn(d, a, b))});
}

}  // namespace liftarm::linkages
