#include "analysis/constraints_screws.h"

#include <algorithm>
#include <cstddef>

#include "analysis/rank.h"

namespace liftarm::analysis {

using lattice::Vec3;

Twist turning(Vec3 at, Vec3 axis) {
  return {lattice::cross(at, axis), axis};
}

Twist shifting(Vec3 axis) {
  return {axis, {}};
}

std::vector<Twist> screwsOf(const Link& link) {
  std::vector<Twist> screws;
  if (link.turns) {
    screws.push_back(turning(link.at, link.axis));
  }
  if (link.shifts) {
    screws.push_back(shifting(link.axis));
  }
  return screws;
}

std::array<double, 6> scaled(const Twist& twist, Vec3 origin, double unit) {
  const Vec3 linear = twist.velocityAt(origin);
  const Vec3 angular = twist.angular;
  return {linear.x / unit, linear.y / unit, linear.z / unit, angular.x, angular.y, angular.z};
}

bool haveIndependentScrews(const std::vector<Link>& links) {
  std::vector<Twist> screws;
  double unit = 1.0;
  for (const Link& link : links) {
    unit = std::max(unit, lattice::length(link.at - links.front().at));
    for (const Twist& screw : screwsOf(link)) {
      screws.push_back(screw);
    }
  }
  if (screws.size() > 6) {
    return false;
  }
  ColumnMatrix matrix(6, screws.size());
  for (std::size_t j = 0; j < screws.size(); ++j) {
    const std::array<double, 6> column = scaled(screws[j], links.front().at, unit);
    std::copy(column.begin(), column.end(), matrix.column(j));
  }
  return findNullBasis(matrix, std::vector<int>(screws.size(), 0)).rank == screws.size();
}

}  // namespace liftarm::analysis
