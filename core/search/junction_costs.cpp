#include "search/junction_costs.h"

#include "base/index.h"
#include "guide/layer_field.h"
#include "layout/axle_collisions.h"
#include "layout/stack.h"

namespace liftarm::search {

using base::at;
using layout::Beam;
using layout::Cover;

double JunctionCosts::cost(int place, unsigned own) const {
  if ((own & unwanted_[at(place)]) != 0U) {
    return costs_.violation;
  }
  const layout::StackFaults faults = layout::stackFaults(others_[at(place)] | own);
  const int filled = problem_->spacers ? faults.fillable : 0;
  const int with = faults.gaps - filled + faults.overfull;
  return costs_.spacer * static_cast<double>(filled) +
         costs_.violation * weights_[at(place)] * static_cast<double>(with);
}

void JunctionCosts::prepare(const layout::Layout& layout, const CoverRequest& request) {
  const guide::GuideRun& run = problem_->graph.runs[at(request.run)];
  mixed_.assign(at(run.edgeCount() + 4), 0);
  places_.assign(at(run.edgeCount() + 4), -1);
  others_.clear();
  unwanted_.clear();
  weights_.clear();
  for (std::size_t j = 0; j < run.junctions.size(); ++j) {
    addJunction(layout, request, j);
  }
}

void JunctionCosts::addJunction(const layout::Layout& layout,
                                const CoverRequest& request,
                                std::size_t j) {
  const guide::GuideRun& run = problem_->graph.runs[at(request.run)];
  const guide::Junction& junction = problem_->graph.junctions[at(run.junctions[j])];
  unsigned others = 0;
  bool mixed = false;
  for (const guide::Incidence& incidence : junction.incident) {
    const Cover& cover = layout.run(incidence.run).cover;
    if (incidence.run == request.run) {
      continue;
    }
    if (cover.axle.used()) {
      const guide::GuideRun& other = problem_->graph.runs[at(incidence.run)];
      mixed = mixed || request.axis != layout::alongAxisOf(other).axis;
      continue;
    }
    if (cover.axis != request.axis) {
      mixed = true;
      continue;
    }
    for (const Beam& beam : cover.beams) {
      if (beam.hasHoleAt(incidence.index)) {
        others |= layerBit(beam.layer);
      }
    }
  }
  const int node = run.junctionIndices[j];
  mixed_[index(node)] = mixed && guide::mayBridge(run, junction) ? 1 : 0;
  places_[index(node)] = static_cast<int>(others_.size());
  others_.push_back(others);
  const int wanted = request.preferred.empty() ? guide::kNoLayer : request.preferred[j];
  unwanted_.push_back(wanted == guide::kNoLayer ? 0U : ~layerBit(wanted));
  weights_.push_back(layout.junctionWeights()[at(run.junctions[j])]);
}

}  // namespace liftarm::search
