#include "analysis/frame_spin.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "analysis/union_find.h"

namespace liftarm::analysis {

namespace {

using lattice::Vec3;
using model::Connection;

Vec3 axisOf(const Scene& scene, const Connection& c) {
  const auto part = static_cast<std::size_t>(c.female);
  return scene.model->parts[part].pose.rotation *
         scene.parts[part].part->features[static_cast<std::size_t>(c.femaleFeature)].axis;
}

bool onOneAxis(const Scene& scene, const Connection& a, const Connection& b) {
  const Vec3 axis = axisOf(scene, a);
  return std::abs(lattice::dot(axis, axisOf(scene, b))) > model::kCoaxialCosine &&
         lattice::length(lattice::cross(axis, b.at - a.at)) < model::kCoaxialDistance;
}

//! Whether all that a part has lies on one axis: it looks the same however it is turned about it.
bool canIdle(const parts::Part* part) {
  if (part == nullptr || part->features.empty()) {
    return false;
  }
  const parts::Feature& first = part->features.front();
  return std::all_of(
      part->features.begin(), part->features.end(), [&](const parts::Feature& other) {
        return std::abs(lattice::dot(first.axis, other.axis)) > model::kCoaxialCosine &&
               lattice::length(lattice::cross(first.axis, other.center - first.center)) <
                   model::kCoaxialDistance;
      });
}

}  // namespace

std::vector<bool> idleHolds(const Scene& scene) {
  UnionFind groups(scene.parts.size());
  for (const Connection& c : scene.connections) {
    if (c.fit == model::Fit::kRigid) {
      groups.join(c.male, c.female);
    }
  }
  std::vector<bool> idles(scene.parts.size(), true);
  for (std::size_t part = 0; part < scene.parts.size(); ++part) {
    if (!canIdle(scene.parts[part].part)) {
      idles[static_cast<std::size_t>(groups.find(static_cast<int>(part)))] = false;
    }
  }
  std::vector<int> first(scene.parts.size(), -1);  // connection of the group that others compare to
  for (std::size_t i = 0; i < scene.connections.size(); ++i) {
    const Connection& c = scene.connections[i];
    if (c.fit == model::Fit::kRigid || !isGood(c.fit)) {
      continue;
    }
    for (const int part : {c.male, c.female}) {
      const auto group = static_cast<std::size_t>(groups.find(part));
      if (first[group] < 0) {
        first[group] = static_cast<int>(i);
      } else if (!onOneAxis(scene, scene.connections[static_cast<std::size_t>(first[group])], c)) {
        idles[group] = false;
      }
    }
  }
  std::vector<bool> holds(scene.connections.size(), false);
  for (std::size_t group = 0; group < first.size(); ++group) {
    if (idles[group] && first[group] >= 0) {
      holds[static_cast<std::size_t>(first[group])] = true;
    }
  }
  return holds;
}

}  // namespace liftarm::analysis
