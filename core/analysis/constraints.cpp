#include "analysis/constraints.h"

#include <cmath>
#include <cstddef>

namespace liftarm::analysis {

namespace {

using lattice::Vec3;

// Looser than the rounding of a file and far tighter than half a module.
constexpr double kSameLine = 2e-3;  // modules
constexpr double kParallel = 1e-4;  // sine of the angle

bool parallel(const Link& p, const Link& q) {
  return lattice::length(lattice::cross(p.axis, q.axis)) < kParallel;
}

//! Plain pins and axles have no ridges; pins of connectors have them like pins with friction.
bool hasRidges(const parts::Part& part, int feature) {
  return part.features[static_cast<std::size_t>(feature)].kind == parts::FeatureKind::kPin &&
         (part.friction || part.partClass != parts::PartClass::kPin);
}

}  // namespace

Play playOf(const Scene& scene, const model::Connection& connection, Friction friction) {
  if (connection.fit == model::Fit::kRigid) {
    return {};
  }
  const bool held = friction == Friction::kHeld;
  const parts::Part& male = *scene.parts[static_cast<std::size_t>(connection.male)].part;
  return {!held || !hasRidges(male, connection.maleFeature),
          !held && connection.fit == model::Fit::kSlide};
}

Linkage linkageOf(const Scene& scene, Friction friction) {
  Linkage linkage;
  linkage.bodies = static_cast<int>(scene.parts.size());
  for (const model::Connection& c : scene.connections) {
    if (!model::isGood(c.fit)) {
      continue;
    }
    const auto male = static_cast<std::size_t>(c.male);
    const parts::Part& part = *scene.parts[male].part;
    const lattice::Pose& pose = scene.model->parts[male].pose;
    // The head's own line: the same for all holes that it sits in.
    const parts::Feature& head = part.features[static_cast<std::size_t>(c.maleFeature)];
    Link link;
    link.a = c.male;
    link.b = c.female;
    const Play play = playOf(scene, c, friction);
    link.turns = play.turns;
    link.shifts = play.shifts;
    link.at = pose.apply(head.center);
    link.axis = lattice::normalized(pose.rotation * head.axis);
    linkage.links.push_back(link);
  }
  return linkage;
}

bool onOneLine(const Link& p, const Link& q) {
  return parallel(p, q) && lattice::length(lattice::cross(q.at - p.at, p.axis)) < kSameLine;
}

Link together(const Link& p, const Link& q) {
  Link link = p;
  link.shifts = p.shifts && q.shifts && parallel(p, q);
  link.turns = p.turns && q.turns && onOneLine(p, q);
  return link;
}

}  // namespace liftarm::analysis
