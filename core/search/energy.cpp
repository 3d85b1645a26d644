#include "search/energy.h"

#include "search/tuning.h"

namespace liftarm::search {

double weightOf(const objective::Weights& weights, std::string_view term) {
  return weights[*objective::termIndex(term)];
}

Energy::Energy(const layout::LayoutProblem& problem, const objective::Weights& weights)
    : softWeights_(weights), violationWeight_(weightOf(weights, "violations")) {
  measures_.scale = objective::scaleOf(problem.graph);
  softWeights_[*objective::termIndex("violations")] = 0.0;
}

double Energy::soft(const layout::Tallies& tallies) const {
  measures_.tallies = tallies;
  return objective::value(measures_, softWeights_);
}

double Energy::of(const layout::Layout& layout, int missing, int freedoms) const {
  return plain(layout.tallies(), freedoms) +
         violationWeight_ * (layout.weightedViolations() +
                             kTuning.energy.missingShare * static_cast<double>(missing));
}

}  // namespace liftarm::search
