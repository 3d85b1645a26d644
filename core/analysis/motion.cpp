#include "analysis/motion.h"

#include <cstddef>
#include <string>

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
  for (std::size_t j = 0; j < report.joints.size(); ++j) {
    if (!report.joints[j].turns) {
      result.problems.push_back({"joint",
                                 "joints[" + std::to_string(j) + "]: " + report.joints[j].message,
                                 scene.sketch->joints[j].at,
                                 report.joints[j].to.stoppedBy});
    }
  }
  result.detail = std::to_string(report.joints.size() - result.problems.size()) + " of " +
                  std::to_string(report.joints.size()) + " joints turn";
  return result;
}

}  // namespace liftarm::analysis
