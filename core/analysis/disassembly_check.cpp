#include "analysis/disassembly.h"

namespace liftarm::analysis {

ItemResult checkDisassembly(const Scene& scene) {
  ItemResult result;
  if (scene.parts.size() > kMaxPartsTakenApart) {
    result.detail = "not judged: more than " + std::to_string(kMaxPartsTakenApart) + " parts";
    result.problems.push_back({"unjudged", "too many parts to be taken apart here", {}, {}});
    return result;
  }
  const DisassemblyPlan plan = planDisassembly(scene);
  std::size_t moves = 0;
  for (const DisassemblyGroup& group : plan.groups) {
    moves += group.removals.size();
  }
  for (const StuckParts& stuck : plan.stuck) {
    Problem problem{"stuck",
                    stuck.message,
                    scene.model->parts[static_cast<std::size_t>(stuck.parts.front())].pose.position,
                    stuck.parts};
    problem.parts.insert(problem.parts.end(), stuck.by.begin(), stuck.by.end());
    result.problems.push_back(std::move(problem));
  }
  result.detail = "moves: " + std::to_string(moves) +
                  ", groups built apart: " + std::to_string(plan.groups.size() - 1) +
                  ", parts stuck: " + std::to_string(plan.stuck.size());
  return result;
}

}  // namespace liftarm::analysis
