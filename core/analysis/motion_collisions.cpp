#include "analysis/motion_collisions.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "analysis/convex.h"

namespace liftarm::analysis {

namespace {

using lattice::Pose;
using lattice::Vec3;
using parts::Prism;

bool isAtStart(const Pose& pose) {
  return pose.position == Vec3{} && pose.rotation.m == lattice::Mat3{}.m;
}

Prism moved(const Prism& prism, const Pose& pose) {
  return {pose.apply(prism.from),
          pose.apply(prism.to),
          pose.rotation * prism.axis,
          prism.radius,
          prism.halfThickness};
}

}  // namespace

MotionCollisions::MotionCollisions(const Scene& scene, const std::vector<int>& bodyOf) {
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    for (const Shape& shape : scene.parts[i].shapes) {
      pieces_.push_back({static_cast<int>(i), bodyOf[i], shape.prism});
    }
  }
}

bool MotionCollisions::letOff(std::size_t i, std::size_t j) {
  const auto [entry, isNew] = enteredAtStart_.emplace(std::minmax(i, j), false);
  if (isNew) {
    entry->second = overlap(pieces_[i].start, pieces_[j].start, kGrazing);
  }
  return entry->second;
}

std::optional<std::pair<int, int>> MotionCollisions::find(const std::vector<Pose>& poses) {
  std::vector<Prism> prisms;
  std::vector<Box> boxes;
  std::vector<bool> moving;
  for (const Piece& piece : pieces_) {
    const Pose& pose = poses[static_cast<std::size_t>(piece.body)];
    moving.push_back(!isAtStart(pose));
    prisms.push_back(moving.back() ? moved(piece.start, pose) : piece.start);
    boxes.push_back(boundsOf(prisms.back()));
  }
  std::vector<std::size_t> order(pieces_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(boxes[a].min.x, a) < std::pair(boxes[b].min.x, b);
  });
  std::vector<std::size_t> active;
  for (const std::size_t i : order) {
    active.erase(std::remove_if(active.begin(),
                                active.end(),
                                [&](std::size_t j) { return boxes[j].max.x <= boxes[i].min.x; }),
                 active.end());
    for (const std::size_t j : active) {
      if (pieces_[i].body != pieces_[j].body && (moving[i] || moving[j]) &&
          meet(boxes[i], boxes[j], kGrazing) && overlap(prisms[i], prisms[j], kGrazing) &&
          !letOff(i, j)) {
        return std::minmax(pieces_[i].part, pieces_[j].part);
      }
    }
    active.push_back(i);
  }
  return std::nullopt;
}

}  // namespace liftarm::analysis
