#include "analysis/kinematic_chain.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/rank.h"
#include "analysis/union_find.h"
#include "base/check.h"
#include "base/det_math.h"
#include "base/index.h"

namespace liftarm::analysis {

namespace {

using base::at;
using lattice::Pose;
using lattice::Vec3;

constexpr double kClosed = 1e-9;       // modules and radians
constexpr double kLongest = 0.6;       // radians and modules that an angle may change in one move
constexpr double kLongestBend = 0.05;  // what a move may differ by from the one before
constexpr double kFineMove = 9e-3;     // radians of the driver, half a degree: taken as it comes
constexpr int kMaxIterations = 15;
constexpr std::size_t kRows = 5;  // equations per loop

//! Turning about an axis through the origin.
Vec3 turned(Vec3 v, Vec3 axis, double angle) {
  const double c = base::detCos(angle);
  const double s = base::detSin(angle);
  return c * v + s * lattice::cross(axis, v) + ((1 - c) * lattice::dot(axis, v)) * axis;
}

//! The displacement by which a body turns about a line and shifts along it.
Pose displacement(const Link& link, double angle, double shift) {
  Pose pose;
  pose.rotation = lattice::fromColumns(turned({1, 0, 0}, link.axis, angle),
                                       turned({0, 1, 0}, link.axis, angle),
                                       turned({0, 0, 1}, link.axis, angle));
  pose.position = link.at - pose.rotation * link.at + shift * link.axis;
  return pose;
}

//! Two unit vectors across an axis.
std::array<Vec3, 2> squaresTo(Vec3 axis) {
  const Vec3 any = std::abs(axis.z) > 0.6 ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
  const Vec3 first = lattice::normalized(lattice::cross(axis, any));
  return {first, lattice::cross(axis, first)};
}

}  // namespace

KinematicChain::KinematicChain(const Linkage& linkage, const Link& driver, int base, double slack)
    : linkage_(linkage), slack_(std::max(slack, kClosed)) {
  LIFTARM_CHECK(driver.turns && !driver.shifts, "the driver turns");
  linkage_.links.insert(linkage_.links.begin(), driver);
  for (const Link& link : linkage_.links) {
    unit_ = std::max(unit_, lattice::length(link.at - driver.at));
  }
  poses_.resize(at(linkage_.bodies));
  above_.resize(at(linkage_.bodies));
  growTree(base);
}

void KinematicChain::addVariables(int link, int parent, int child) {
  const Link& source = linkage_.links[at(link)];
  above_[at(child)] = above_[at(parent)];
  for (const bool shifts : {false, true}) {
    if (shifts ? source.shifts : source.turns) {
      if (link == 0) {
        driver_ = variables_.size();
      }
      above_[at(child)].push_back(variables_.size());
      variables_.push_back({link, parent, child, source.a == parent ? 1.0 : -1.0, shifts});
    }
  }
}

//! The driver is in the tree; the other links follow in their order where they join something new.
void KinematicChain::growTree(int base) {
  UnionFind joined(at(linkage_.bodies));
  std::vector<std::vector<int>> branches(at(linkage_.bodies));
  for (int l = 0; l < static_cast<int>(linkage_.links.size()); ++l) {
    const Link& link = linkage_.links[at(l)];
    if (joined.find(link.a) == joined.find(link.b)) {
      loops_.push_back(l);
      continue;
    }
    joined.join(link.a, link.b);
    branches[at(link.a)].push_back(l);
    branches[at(link.b)].push_back(l);
  }
  std::vector<bool> reached(at(linkage_.bodies), false);
  std::vector<int> queue{base};
  reached[at(base)] = true;
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const int body = queue[head];
    for (const int l : branches[at(body)]) {
      const Link& link = linkage_.links[at(l)];
      const int next = link.a == body ? link.b : link.a;
      if (!reached[at(next)]) {
        reached[at(next)] = true;
        addVariables(l, body, next);
        queue.push_back(next);
      }
    }
  }
  // Loops in assemblies that do not hang on the base never move.
  loops_.erase(std::remove_if(loops_.begin(),
                              loops_.end(),
                              [&](int l) { return !reached[at(linkage_.links[at(l)].a)]; }),
               loops_.end());
}

void KinematicChain::place() {
  for (std::size_t k = 0; k < variables_.size(); ++k) {
    const Variable& v = variables_[k];
    double angle = v.sign * v.value;
    double shift = 0.0;
    if (v.shifts) {
      shift = angle;
      angle = 0.0;
    } else if (k + 1 < variables_.size() && variables_[k + 1].link == v.link) {
      ++k;
      shift = variables_[k].sign * variables_[k].value;
    }
    poses_[at(v.child)] = lattice::after(poses_[at(v.parent)],
                                         displacement(linkage_.links[at(v.link)], angle, shift));
  }
}

Twist KinematicChain::screwOf(const Variable& variable) const {
  const Link& link = linkage_.links[at(variable.link)];
  const Pose& pose = poses_[at(variable.parent)];
  const Vec3 axis = pose.rotation * link.axis;
  return variable.sign * (variable.shifts ? shifting(axis) : turning(pose.apply(link.at), axis));
}

//! By how much each loop is open: across the line, along it where it may not shift, and in
//! angle.
std::vector<double> KinematicChain::loopErrors() const {
  std::vector<double> errors;
  for (const int l : loops_) {
    const Link& link = linkage_.links[at(l)];
    const Pose& a = poses_[at(link.a)];
    const Pose& b = poses_[at(link.b)];
    const Vec3 axis = a.rotation * link.axis;
    const Vec3 gap = b.apply(link.at) - a.apply(link.at);
    const Vec3 other = b.rotation * link.axis;
    for (const Vec3 side : squaresTo(axis)) {
      errors.push_back(lattice::dot(gap, side) / unit_);
      errors.push_back(lattice::dot(other, side));
    }
    errors.push_back(link.shifts ? 0.0 : lattice::dot(gap, axis) / unit_);
  }
  return errors;
}

//! One step of Newton on all variables but the driver. \return The largest change.
double KinematicChain::improve(const std::vector<double>& errors) {
  ColumnMatrix matrix(errors.size(), variables_.size());
  for (std::size_t i = 0; i < loops_.size(); ++i) {
    const Link& link = linkage_.links[at(loops_[i])];
    const Vec3 axis = poses_[at(link.a)].rotation * link.axis;
    const Vec3 place = poses_[at(link.b)].apply(link.at);
    const std::array<Vec3, 2> sides = squaresTo(axis);
    const auto addColumn = [&](std::size_t k, double sign) {
      if (k == driver_) {
        return;
      }
      const Twist screw = sign * screwOf(variables_[k]);
      const Vec3 velocity = screw.velocityAt(place);
      const Vec3 swing = lattice::cross(screw.angular, axis);
      double* column = matrix.column(k) + kRows * i;
      for (std::size_t s = 0; s < 2; ++s) {
        column[2 * s] += lattice::dot(velocity, sides[s]) / unit_;
        column[2 * s + 1] += lattice::dot(swing, sides[s]);
      }
      column[4] += link.shifts ? 0.0 : lattice::dot(velocity, axis) / unit_;
    };
    for (const std::size_t k : above_[at(link.b)]) {
      addColumn(k, 1.0);
    }
    for (const std::size_t k : above_[at(link.a)]) {
      addColumn(k, -1.0);
    }
  }
  const std::vector<double> change = solveNearest(matrix, errors);
  double largest = 0.0;
  for (std::size_t k = 0; k < variables_.size(); ++k) {
    variables_[k].value -= change[k];
    largest = std::max(largest, std::abs(change[k]));
  }
  return largest;
}

bool KinematicChain::closeLoops() {
  double change = 1.0;
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    place();
    const std::vector<double> errors = loopErrors();
    double worst = 0.0;
    for (const double error : errors) {
      worst = std::max(worst, std::abs(error));
    }
    // Loops whose lengths contradict each other come as near as they can.
    if (worst < kClosed || (worst < slack_ && change < kClosed)) {
      return !jumped();
    }
    if (jumped()) {
      return false;
    }
    change = improve(errors);
  }
  return false;
}

bool KinematicChain::jumped() const {
  return std::any_of(variables_.begin(), variables_.end(), [](const Variable& v) {
    return std::abs(v.value - v.start) > kLongest;
  });
}

//! Whether the move goes on as the one before did. Where two dead points lie close together, loops
//! close on both sides of the gap, and a long step would leap it: links that rushed towards the one
//! come back from the other.
bool KinematicChain::isSmooth(double turn) const {
  return std::abs(turn) < kFineMove ||
         std::all_of(variables_.begin(), variables_.end(), [&](const Variable& v) {
           return !v.rate.has_value() ||
                  std::abs(v.value - v.start - *v.rate * turn) < kLongestBend;
         });
}

bool KinematicChain::moveTo(double angle) {
  if (!driver_.has_value()) {
    return false;
  }
  for (Variable& v : variables_) {
    v.start = v.value;
  }
  // A link's angle is that of its b against its a; the sign puts it into the tree's direction.
  const double turn = angle - variables_[*driver_].value;
  variables_[*driver_].value = angle;
  if (closeLoops() && isSmooth(turn)) {
    for (Variable& v : variables_) {
      v.rate = turn != 0.0 ? std::optional((v.value - v.start) / turn) : v.rate;
    }
    return true;
  }
  for (Variable& v : variables_) {
    v.value = v.start;
  }
  place();
  return false;
}

}  // namespace liftarm::analysis
