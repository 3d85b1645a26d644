#include "analysis/motion.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>

#include "model/number_text.h"

namespace liftarm::analysis {

namespace {

//! Which two of three and more bodies a range is about.
std::string pairText(const JointRange& range) {
  return range.pair.has_value() ? "bodies " + std::to_string(range.pair->first) + " and " +
                                      std::to_string(range.pair->second) + ": "
                                : "";
}

}  // namespace

MotionReport analyseFreedoms(const Scene& scene, const std::vector<EdgeCover>& coverage) {
  MotionReport report;
  const JointMover mover(scene, coverage);
  report.free = mover.free();
  report.held = mover.held();
  for (int joint = 0; joint < mover.joints(); ++joint) {
    report.joints.push_back(mover.turnJoint(joint).range);
  }
  report.trains = findGearTrains(scene);
  return report;
}

MotionReport analyseMotion(const Scene& scene, const std::vector<EdgeCover>& coverage) {
  MotionReport report = analyseFreedoms(scene, coverage);
  report.balance = checkBalance(scene);
  report.braces = findBraces(scene, coverage, report.free);
  return report;
}

namespace {

constexpr double kRangeError = 0.5;  // degrees: stops are found half as well

bool missesFrom(const sketch::Joint& joint, const JointRange& range) {
  return joint.range.has_value() && range.from.degrees > (*joint.range)[0] + kRangeError;
}

bool missesTo(const sketch::Joint& joint, const JointRange& range) {
  return joint.range.has_value() && range.to.degrees < (*joint.range)[1] - kRangeError;
}

//! What is missing of a required range, or nothing.
std::string shortfall(const sketch::Joint& joint, const JointRange& range) {
  if (!missesFrom(joint, range) && !missesTo(joint, range)) {
    return "";
  }
  return " It must turn from " + model::numberText((*joint.range)[0], 1) + " to " +
         model::numberText((*joint.range)[1], 1) + " degrees.";
}

std::vector<int> stopOf(const sketch::Joint& joint, const JointRange& range) {
  return missesFrom(joint, range) && !missesTo(joint, range) ? range.from.stoppedBy
                                                             : range.to.stoppedBy;
}

}  // namespace

ItemResult checkJoints(const Scene& scene, const MotionReport& report) {
  ItemResult result;
  std::optional<double> least;  // of those that turn
  std::set<int> joints;
  std::set<int> stiff;
  for (const JointRange& range : report.joints) {
    joints.insert(range.joint);
    if (range.turns) {
      const double degrees = range.to.degrees - range.from.degrees;
      least = std::min(least.value_or(degrees), degrees);
    }
    const sketch::Joint& joint = scene.sketch->joints[static_cast<std::size_t>(range.joint)];
    const std::string missing = range.turns ? shortfall(joint, range) : "";
    if (range.turns && missing.empty()) {
      continue;
    }
    stiff.insert(range.joint);
    result.problems.push_back({"joint",
                               "joints[" + std::to_string(range.joint) + "]: " + pairText(range) +
                                   range.message + missing,
                               joint.at,
                               stopOf(joint, range)});
  }
  result.detail = std::to_string(joints.size() - stiff.size()) + " of " +
                  std::to_string(joints.size()) + " joints turn";
  if (least.has_value()) {
    result.detail += ", by at least " + model::numberText(*least, 1) + " degrees";
  }
  return result;
}

}  // namespace liftarm::analysis
