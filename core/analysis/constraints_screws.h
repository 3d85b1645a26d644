#pragma once

#include <array>
#include <vector>

#include "analysis/constraints.h"

namespace liftarm::analysis {

//! \brief A velocity of a body: angular, and that of the body's point at the origin \cite
//! davidson_2004_robots (screws). Radians and modules, per unit of time.
struct Twist {
  lattice::Vec3 linear;
  lattice::Vec3 angular;

  [[nodiscard]] lattice::Vec3 velocityAt(lattice::Vec3 p) const {
    return linear + lattice::cross(angular, p);
  }

  friend Twist operator+(const Twist& a, const Twist& b) {
    return {a.linear + b.linear, a.angular + b.angular};
  }

  friend Twist operator-(const Twist& a, const Twist& b) {
    return {a.linear - b.linear, a.angular - b.angular};
  }

  friend Twist operator*(double s, const Twist& a) { return {s * a.linear, s * a.angular}; }
};

//! \brief Turning about a line at one radian. \param at Any point of the line.
Twist turning(lattice::Vec3 at, lattice::Vec3 axis);

//! \brief Shifting along a line at one module.
Twist shifting(lattice::Vec3 axis);

//! \brief The twists that a link allows.
std::vector<Twist> screwsOf(const Link& link);

//! \brief A twist as six numbers, lengths from `origin` and divided by `unit`, so that all are of
//! the order of one.
std::array<double, 6> scaled(const Twist& twist, lattice::Vec3 origin, double unit);

//! \brief Whether no combination of the links' twists but zero is zero: then a loop of these links
//! cannot move. More than six twists never are independent.
bool haveIndependentScrews(const std::vector<Link>& links);

}  // namespace liftarm::analysis
