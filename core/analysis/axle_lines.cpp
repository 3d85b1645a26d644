#include "analysis/axle_lines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace liftarm::analysis {

namespace {

using lattice::Vec3;

constexpr double kEndSlot = 0.5;  // a node at the end of a line is in the middle of a slot

}  // namespace

AxleLines::AxleLines(const Scene& scene) : scene_(scene) {
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const parts::Part* part = scene.parts[i].part;
    if (part == nullptr || part->partClass != parts::PartClass::kAxle) {
      continue;
    }
    const lattice::Pose& pose = scene.model->parts[i].pose;
    for (const parts::Feature& feature : part->features) {
      if (feature.kind == parts::FeatureKind::kAxle) {
        shafts_.push_back({static_cast<int>(i),
                           pose.apply(feature.center),
                           lattice::normalized(pose.rotation * feature.axis),
                           0.5 * feature.length});
      }
    }
  }
}

std::vector<int> AxleLines::along(Vec3 a, Vec3 b) const {
  std::vector<int> found;
  for (const Shaft& shaft : shafts_) {
    const auto passes = [&](Vec3 p) {
      const Vec3 offset = p - shaft.middle;
      const double on = lattice::dot(offset, shaft.axis);
      return lattice::length(offset - on * shaft.axis) <= model::kCoaxialDistance &&
             std::abs(on) <= shaft.half - kEndSlot + model::kCoaxialDistance;
    };
    if (passes(a) && passes(b)) {
      found.push_back(shaft.part);
    }
  }
  return found;
}

std::vector<int> AxleLines::ofLines(const std::vector<int>& lines,
                                    const std::vector<EdgeCover>& coverage) const {
  std::vector<int> found;
  for (const EdgeCover& edge : coverage) {
    if (!edge.covers.empty() || std::count(lines.begin(), lines.end(), edge.line) == 0) {
      continue;
    }
    for (const int axle : along(edge.from, edge.to)) {
      if (std::count(found.begin(), found.end(), axle) == 0) {
        found.push_back(axle);
      }
    }
  }
  return found;
}

std::vector<const model::Connection*> AxleLines::heldBy(int axle) const {
  std::vector<const model::Connection*> held;
  for (const model::Connection& c : scene_.connections) {
    const bool beam =
        scene_.parts[static_cast<std::size_t>(c.female)].part->partClass == parts::PartClass::kBeam;
    if (c.male == axle && beam && model::isGood(c.fit) && c.fit != model::Fit::kSlide) {
      held.push_back(&c);
    }
  }
  return held;
}

}  // namespace liftarm::analysis
