#pragma once

#include <cmath>

namespace liftarm::linkages {

//! \brief A point of the linkage's plane, in modules; also a complex number u + i v.
struct Point {
  double u = 0.0;
  double v = 0.0;

  friend Point operator+(Point a, Point b) { return {a.u + b.u, a.v + b.v}; }

  friend Point operator-(Point a, Point b) { return {a.u - b.u, a.v - b.v}; }

  friend Point operator*(double s, Point a) { return {s * a.u, s * a.v}; }

  //! The complex product: turns and scales.
  friend Point operator*(Point a, Point b) {
    return {a.u * b.u - a.v * b.v, a.u * b.v + a.v * b.u};
  }
};

inline Point conjugate(Point a) {
  return {a.u, -a.v};
}

inline double dot(Point a, Point b) {
  return a.u * b.u + a.v * b.v;
}

inline double cross(Point a, Point b) {
  return a.u * b.v - a.v * b.u;
}

inline double length(Point a) {
  return std::sqrt(dot(a, a));
}

//! \brief The foot of a perpendicular, kept on the segment.
Point nearestOn(Point p, Point from, Point to);

//! \brief How near two segments come to each other; 0 where they cross.
double distanceBetween(Point a, Point b, Point c, Point d);

}  // namespace liftarm::linkages
