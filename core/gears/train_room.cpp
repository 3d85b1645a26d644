#include "gears/train_room.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "gears/gear_sizes.h"

namespace liftarm::gears {

namespace {

constexpr double kSpare = 0.02;  // modules between two that pass each other

//! Gears in mesh follow on each other; those of one shaft do too.
bool mesh(const TrainGear& p, const TrainGear& q) {
  return &q - &p == 1 || &p - &q == 1;
}

}  // namespace

bool keepApart(const Disc& p, const Disc& q) {
  if (p.plane.has_value() && q.plane.has_value() && *p.plane != *q.plane) {
    return true;
  }
  const Place way = p.at - q.at;
  return std::sqrt(static_cast<double>(way.u * way.u + way.v * way.v)) >=
         p.radius + q.radius + kSpare;
}

Disc discOf(const Train& train, const TrainGear& gear) {
  return {train.shafts[static_cast<std::size_t>(gear.shaft)], gear.plane, tipRadius(gear.teeth)};
}

bool TrainRoom::holds(const Train& train) const {
  return std::all_of(train.gears.begin(), train.gears.end(), [&](const TrainGear& gear) {
    return hasRoom(train, gear);
  });
}

bool TrainRoom::hasRoom(const Train& train, const TrainGear& gear) const {
  const Disc disc = discOf(train, gear);
  if (request_.clear != nullptr && !request_.clear(disc)) {
    return false;
  }
  const auto apart = [&](const Disc& other) { return keepApart(disc, other); };
  for (std::size_t s = 0; s < train.shafts.size(); ++s) {
    if (static_cast<int>(s) != gear.shaft && !apart({train.shafts[s], std::nullopt, kAxleRadius})) {
      return false;
    }
  }
  for (const TrainGear& other : train.gears) {
    if (other.shaft != gear.shaft && !mesh(gear, other) && !apart(discOf(train, other))) {
      return false;
    }
  }
  return std::all_of(request_.taken.begin(), request_.taken.end(), apart);
}

}  // namespace liftarm::gears
