#include "analysis/motion.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "model/number_text.h"

namespace liftarm::analysis {

MotionReport analyseFreedoms(const Scene& scene, const std::vector<EdgeCover>& coverage) {
  MotionReport report;
  const JointMover mover(scene, coverage);
  report.free = mover.free();
  report.held = mover.held();
  for (int joint = 0; joint < mover.joints(); ++joint) {
    report.joints.push_back(mover.turnJoint(joint).range);
  }
  return report;
}

MotionReport analyseMotion(const Scene& scene, const std::vector<EdgeCover>& coverage) {
  MotionReport report = analyseFreedoms(scene, coverage);
  report.balance = checkBalance(scene);
  report.braces = findBraces(scene, coverage, report.free);
  return report;
}

ItemResult checkJoints(const Scene& scene, const MotionReport& report) {
  ItemResult result;
  std::optional<double> least;  // of those that turn
  for (std::size_t j = 0; j < report.joints.size(); ++j) {
    const JointRange& range = report.joints[j];
    if (range.turns) {
      const double degrees = range.to.degrees - range.from.degrees;
      least = std::min(least.value_or(degrees), degrees);
    }
    if (!range.turns) {
      result.problems.push_back({"joint",
                                 "joints[" + std::to_string(j) + "]: " + range.message,
                                 scene.sketch->joints[j].at,
                                 range.to.stoppedBy});
    }
  }
  result.detail = std::to_string(report.joints.size() - result.problems.size()) + " of " +
                  std::to_string(report.joints.size()) + " joints turn";
  if (least.has_value()) {
    result.detail += ", by at least " + model::numberText(*least, 1) + " degrees";
  }
  return result;
}

}  // namespace liftarm::analysis
