#include "design/measures.h"

#include "layout/components.h"
#include "objective/rigidity_measure.h"

namespace liftarm::design {

std::vector<objective::SymmetryGroup> symmetryGroups(const guide::GuidingGraph& graph) {
  std::vector<objective::SymmetryGroup> groups;
  for (const guide::GuideSymmetry& s : graph.symmetries) {
    groups.push_back({{s.linear, s.shift}, s.runs, s.partners});
  }
  return groups;
}

objective::Measures measuresOf(const layout::LayoutProblem& problem,
                               const mechanisms::MechanismTable& table,
                               const search::LayoutSnapshot& best) {
  objective::Measures measures;
  measures.tallies = best.tallies;
  measures.scale = objective::scaleOf(problem.graph);
  if (best.covers.empty()) {
    return measures;
  }
  const layout::Components components = layout::findComponents(problem.graph, best.covers);
  measures.componentRange = layout::largestLayerRange(components, best.covers);
  measures.symmetryDeviation =
      objective::symmetryDeviation(problem.graph, best.covers, symmetryGroups(problem.graph));
  measures.rigidSubsets =
      objective::countRigidSubsets(problem.graph, table, best.covers, best.junctions);
  return measures;
}

}  // namespace liftarm::design
