#include "analysis/joint_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "analysis/kinematic_chain.h"
#include "analysis/motion_collisions.h"
#include "analysis/union_find.h"
#include "base/index.h"
#include "model/number_text.h"
#include "model/seating.h"

namespace liftarm::analysis {

namespace {

using base::at;
using lattice::Pose;
using lattice::Vec3;

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kHalfTurn = 180.0;     // degrees
constexpr double kLargestStep = 5.0;    // degrees
constexpr double kSmallestStep = 0.25;  // degrees; stops are found this well
constexpr double kLargestShift = 0.4;   // modules that a part may move in one step
constexpr double kMoving = 1e-6;        // radians or modules per unit

//! The linkage with one freedom left: the other motions' drivers are locked.
MergedLinkage lockOthers(const Freedoms& freedoms, int motion) {
  MergedLinkage locked = freedoms.merged;
  for (std::size_t m = 0; m < freedoms.motions.size(); ++m) {
    const FreeMotion& other = freedoms.motions[m];
    Link& link = locked.linkage.links[at(other.link)];
    if (static_cast<int>(m) != motion) {
      link.turns = link.turns && other.link == freedoms.motions[at(motion)].link;
      link.shifts = false;
    }
  }
  const MergedLinkage merged = mergeAll(locked.linkage);
  locked.linkage = merged.linkage;
  for (int& body : locked.bodyOf) {
    body = merged.bodyOf[at(body)];
  }
  return locked;
}

//! The farthest that a corner of a moving part is from the driver's line.
double reachOf(const Scene& scene, const std::vector<int>& bodyOf, int base, const Link& driver) {
  double reach = 1.0;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const Box& box = scene.parts[i].box;
    if (bodyOf[i] == base || box.empty()) {
      continue;
    }
    for (unsigned corner = 0; corner < 8; ++corner) {
      Vec3 p = box.min;
      for (int k = 0; k < 3; ++k) {
        p[k] = (corner >> static_cast<unsigned>(k) & 1U) != 0 ? box.max[k] : p[k];
      }
      reach = std::max(reach, lattice::length(lattice::cross(p - driver.at, driver.axis)));
    }
  }
  return reach;
}

//! Goes one way from the start until something stops it.
class RangeSweep {
 public:
  RangeSweep(KinematicChain chain, MotionCollisions& collisions, double step)
      : chain_(std::move(chain)), collisions_(collisions), step_(step) {}

  //! \param sign 1 or -1. \return Where it ended; keys() has the way there.
  RangeEnd run(double sign) {
    RangeEnd end;
    double step = step_;
    while (end.degrees < kHalfTurn) {
      const double next = std::min(end.degrees + step, kHalfTurn);
      std::optional<std::pair<int, int>> hit;
      const bool moved = chain_.moveTo(sign * next * kDegree);
      if (moved) {
        hit = collisions_.find(chain_.poses());
      }
      if (moved && !hit.has_value()) {
        end.degrees = next;
        step = std::min(step_, 2 * step);
        keys_.emplace_back(sign * next, chain_.poses());
        continue;
      }
      end.stoppedBy.clear();
      if (hit.has_value()) {
        end.stoppedBy = {hit->first, hit->second};
        chain_.moveTo(sign * end.degrees * kDegree);
      }
      step /= 2;
      if (step < kSmallestStep) {
        break;
      }
    }
    if (end.degrees >= kHalfTurn) {
      end.stoppedBy.clear();
    }
    end.degrees *= sign;
    return end;
  }

  [[nodiscard]] const std::vector<std::pair<double, std::vector<Pose>>>& keys() const {
    return keys_;
  }

 private:
  KinematicChain chain_;
  MotionCollisions& collisions_;
  double step_;
  std::vector<std::pair<double, std::vector<Pose>>> keys_;  // degrees, pose per body
};

bool isFullTurn(const JointRange& range) {
  return range.to.degrees - range.from.degrees >= 2 * kHalfTurn - kSmallestStep;
}

std::string endText(const Scene& scene, const RangeEnd& end) {
  const std::string angle = model::numberText(end.degrees, 1) + " degrees";
  if (!end.stoppedBy.empty()) {
    return angle + " (" + nameOf(scene, end.stoppedBy[0]) + " meets " +
           nameOf(scene, end.stoppedBy[1]) + ")";
  }
  return angle + (std::abs(end.degrees) < kHalfTurn ? " (dead point)" : "");
}

//! Key poses from both sweeps, thinned out to about the largest step.
MotionPath makePath(const Scene& scene,
                    const std::vector<int>& bodyOf,
                    const RangeSweep& back,
                    const RangeSweep& forth) {
  std::vector<std::pair<double, std::vector<Pose>>> keys;
  const auto keep = [&](const RangeSweep& sweep) {
    double last = 0.0;
    for (const auto& key : sweep.keys()) {
      if (std::abs(key.first - last) > kLargestStep * 0.8 || &key == &sweep.keys().back()) {
        keys.push_back(key);
        last = key.first;
      }
    }
  };
  keep(back);
  std::reverse(keys.begin(), keys.end());
  const std::size_t bodies = static_cast<std::size_t>(
      bodyOf.empty() ? 0 : *std::max_element(bodyOf.begin(), bodyOf.end()) + 1);
  keys.emplace_back(0.0, std::vector<Pose>(bodies));
  keep(forth);
  MotionPath path;
  for (std::size_t i = 0; i < bodyOf.size(); ++i) {
    const bool moves = std::any_of(keys.begin(), keys.end(), [&](const auto& key) {
      const Pose& pose = key.second[at(bodyOf[i])];
      return pose.position != Vec3{} || pose.rotation.m != lattice::Mat3{}.m;
    });
    if (moves) {
      path.parts.push_back(static_cast<int>(i));
    }
  }
  for (const auto& [degrees, poses] : keys) {
    path.degrees.push_back(degrees);
    path.poses.emplace_back();
    for (const int i : path.parts) {
      path.poses.back().push_back(
          lattice::after(poses[at(bodyOf[at(i)])], scene.model->parts[at(i)].pose));
    }
  }
  return path;
}

}  // namespace

JointMover::JointMover(const Scene& scene, const std::vector<EdgeCover>& coverage) : scene_(scene) {
  free_.query = makeFreedomsQuery(scene, coverage, Friction::kFree);
  free_.freedoms = findFreedoms(free_.query);
  held_.query = makeFreedomsQuery(scene, coverage, Friction::kHeld);
  held_.freedoms = findFreedoms(held_.query);
  // Twice the error of one head: both ends of a link may be off. More than that no pin has.
  constexpr double kMostPlay = 0.02;
  std::vector<const parts::Part*> parts;
  for (const ScenePart& part : scene.parts) {
    parts.push_back(part.part);
  }
  slack_ = std::min(kMostPlay, 2.0 * model::seatingError(*scene.model, parts, scene.connections));
}

std::string JointMover::whyStiff(int joint) const {
  const JointLine& line = free_.query.joints[at(joint)];
  const Freedoms& freedoms = free_.freedoms;
  if (!line.hasBothSides()) {
    return "no beam covers the lines on one of its sides";
  }
  if (freedoms.merged.bodyOf[at(*line.a)] == freedoms.merged.bodyOf[at(*line.b)]) {
    return nameOf(scene_, *line.a) + " and " + nameOf(scene_, *line.b) +
           " on its sides are held together as one rigid body";
  }
  UnionFind together(at(free_.query.linkage.bodies));
  for (const Link& link : free_.query.linkage.links) {
    together.join(link.a, link.b);
  }
  if (together.find(*line.a) != together.find(*line.b)) {
    return nameOf(scene_, *line.a) + " and " + nameOf(scene_, *line.b) +
           " on its sides are not connected";
  }
  const bool onAxis =
      std::all_of(freedoms.motions.begin(), freedoms.motions.end(), [&](const FreeMotion& m) {
        return jointMove(line, m.twists).onAxis;
      });
  if (!onAxis) {
    return nameOf(scene_, *line.a) + " and " + nameOf(scene_, *line.b) +
           " on its sides move against each other, but not about its axis";
  }
  return "the rest of the model holds its sides against each other";
}

JointMotion JointMover::turnJoint(int joint) const {
  const JointLine& line = free_.query.joints[at(joint)];
  JointMotion result = turnLine(joint);
  result.range.joint = line.joint;
  result.range.pair = line.pair;
  return result;
}

JointMotion JointMover::turnLine(int joint) const {
  JointMotion result;
  const bool turnsHeld = held_.freedoms.jointTurns[at(joint)];
  if (!turnsHeld && !free_.freedoms.jointTurns[at(joint)]) {
    result.range.message = "Does not turn: " + whyStiff(joint) + ".";
    return result;
  }
  const Study& study = turnsHeld ? held_ : free_;
  const JointLine& line = study.query.joints[at(joint)];
  std::optional<int> best;
  for (std::size_t m = 0; m < study.freedoms.motions.size(); ++m) {
    const FreeMotion& motion = study.freedoms.motions[m];
    const bool turns = std::abs(jointMove(line, motion.twists).rate) > kMoving;
    if (motion.joint == joint || (!best.has_value() && turns)) {
      best = static_cast<int>(m);
    }
  }
  if (!best.has_value()) {
    result.range.message = "Does not turn: " + whyStiff(joint) + ".";
    return result;
  }
  Link driver;
  driver.a = *line.a;
  driver.b = *line.b;
  driver.at = line.at;
  driver.axis = line.axis;
  result = run(study, *best, driver);
  if (!turnsHeld && result.range.turns) {
    result.range.message += " Pins with friction turn with it.";
  }
  return result;
}

JointMotion JointMover::follow(int motion) const {
  const FreeMotion& source = free_.freedoms.motions[at(motion)];
  if (source.joint >= 0) {
    return turnJoint(source.joint);
  }
  JointMotion result;
  if (source.shifts) {
    result.range.message = "An axle shifts in a pin hole: nothing turns.";
    return result;
  }
  Link driver = free_.freedoms.merged.linkage.links[at(source.link)];
  driver.shifts = false;
  const auto partOf = [&](int body) {
    const std::vector<int>& bodies = free_.freedoms.merged.bodyOf;
    return static_cast<int>(std::find(bodies.begin(), bodies.end(), body) - bodies.begin());
  };
  driver.a = partOf(driver.a);
  driver.b = partOf(driver.b);
  return run(free_, motion, driver);
}

//! The heaviest body at rest in a motion, of those that links or the driver join to the driver.
int JointMover::baseOf(const Study& study,
                       int motion,
                       const MergedLinkage& locked,
                       const Link& driver) {
  UnionFind joined(at(locked.linkage.bodies));
  joined.join(driver.a, driver.b);
  for (const Link& link : locked.linkage.links) {
    joined.join(link.a, link.b);
  }
  std::vector<double> weights(at(locked.linkage.bodies), 0.0);
  for (std::size_t i = 0; i < locked.bodyOf.size(); ++i) {
    const Twist& twist = study.freedoms.motions[at(motion)].twists[i];
    const int body = locked.bodyOf[i];
    if (lattice::length(twist.linear) + lattice::length(twist.angular) < kMoving &&
        joined.find(body) == joined.find(driver.a)) {
      weights[at(body)] += 1e-6 + study.query.weight[i];
    }
  }
  const auto heaviest = std::max_element(weights.begin(), weights.end());
  return *heaviest > 0.0 ? static_cast<int>(heaviest - weights.begin()) : driver.a;
}

//! \param driver Between two parts.
JointMotion JointMover::run(const Study& study, int motion, Link driver) const {
  const MergedLinkage locked = lockOthers(study.freedoms, motion);
  driver.a = locked.bodyOf[at(driver.a)];
  driver.b = locked.bodyOf[at(driver.b)];
  JointMotion result;
  if (driver.a == driver.b) {
    result.range.message = "Does not turn: the rest of the model holds it.";
    return result;
  }
  const int base = baseOf(study, motion, locked, driver);
  const double reach = reachOf(scene_, locked.bodyOf, base, driver);
  const double step = std::clamp(kLargestShift / reach / kDegree, 2 * kSmallestStep, kLargestStep);
  MotionCollisions collisions(scene_, locked.bodyOf);
  const KinematicChain chain(locked.linkage, driver, base, slack_);
  RangeSweep forth(chain, collisions, step);
  RangeSweep back(chain, collisions, step);
  JointRange& range = result.range;
  range.to = forth.run(1.0);
  range.from = back.run(-1.0);
  range.turns = range.to.degrees - range.from.degrees >= 2 * kSmallestStep;
  if (!range.turns) {
    range.message = "Does not turn: it is stopped at once, at " + endText(scene_, range.from) +
                    " and at " + endText(scene_, range.to) + ".";
    return result;
  }
  range.message = isFullTurn(range) ? "Turns all the way round."
                                    : "Turns from " + endText(scene_, range.from) + " to " +
                                          endText(scene_, range.to) + ".";
  result.path = makePath(scene_, locked.bodyOf, back, forth);
  return result;
}

}  // namespace liftarm::analysis
