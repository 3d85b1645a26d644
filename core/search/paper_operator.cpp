#include "search/paper_operator.h"

#include <algorithm>

#include "base/index.h"
#include "layout/stack.h"

namespace liftarm::search {

namespace {

using base::at;
using guide::kMaxLayer;
using layout::kLayerCount;

constexpr double kLayerNoise = 1.5;
constexpr double kOccupied = 2.0;   // an occupied node against a gap
constexpr double kForbidden = 1e6;  // off an exact line
constexpr double kOutside = 100.0;  // a hole below the ground or in a keep-out box
constexpr double kOffLine = 0.1;    // keeps stacks from drifting away
constexpr int kTries = 64;          // tries to find an edge that can be covered

}  // namespace

PaperOperator::PaperOperator(const layout::LayoutProblem& problem, bool corners, base::Rng* rng)
    : problem_(&problem), corners_(corners), rng_(rng) {
  for (std::size_t r = 0; r < problem.graph.runs.size(); ++r) {
    for (int e = 0; e < problem.graph.runs[r].edgeCount(); ++e) {
      edges_.emplace_back(static_cast<int>(r), e);
    }
  }
}

void PaperOperator::initialise(PaperLayout* beams) {
  std::vector<std::pair<int, int>> order = edges_;
  for (std::size_t i = order.size(); i > 1; --i) {
    std::swap(order[i - 1], order[rng_->below(static_cast<std::uint32_t>(i))]);
  }
  for (const auto& [run, edge] : order) {
    if (!beams->coverable(run, edge) || beams->covered(run, edge)) {
      continue;
    }
    std::vector<PaperPlacement> fitting;
    for (const PaperPlacement& p : beams->placements({run}, corners_)) {
      if (p.start <= edge && p.start + p.holes - 1 > edge) {
        fitting.push_back(p);
      }
    }
    if (!fitting.empty()) {
      const PaperPlacement& p = fitting[rng_->below(static_cast<std::uint32_t>(fitting.size()))];
      beams->add(p, pickLayer(*beams, p));
    }
  }
}

//! Adds up what each layer costs at the nodes of one arm: the first one of `arm`.
void PaperOperator::addLayerCosts(const PaperLayout& beams,
                                  const PaperPlacement& arm,
                                  std::vector<double>* costs) const {
  const guide::GuideRun& guideRun = problem_->graph.runs[at(arm.run)];
  const lattice::Axis axis = beams.cover(arm.run).axis;
  const bool restricted = problem_->graph.ground || !problem_->graph.keepOut.empty();
  for (int i = arm.start; i < arm.start + arm.holes; ++i) {
    const unsigned layers = beams.layersAt(arm.run, i);
    const int gaps = layout::stackFaults(layers).gaps;
    for (int layer = -kMaxLayer; layer <= kMaxLayer; ++layer) {
      const unsigned own = 1U << static_cast<unsigned>(layer + kMaxLayer);
      double cost = (layers & own) != 0
                        ? kOccupied
                        : static_cast<double>(layout::stackFaults(layers | own).gaps - gaps);
      if (restricted &&
          layout::forbiddenAt(problem_->graph,
                              layout::holePosition(problem_->graph, guideRun, axis, i, layer))) {
        cost += kOutside;
      }
      cost += guideRun.allows(layer) ? 0.0 : kForbidden;
      (*costs)[at(layer + kMaxLayer)] += cost;
    }
  }
}

std::vector<double> PaperOperator::layerCosts(const PaperLayout& beams,
                                              const PaperPlacement& placement) const {
  std::vector<double> costs(at(kLayerCount), 0.0);
  addLayerCosts(beams, placement, &costs);
  if (placement.mate >= 0) {
    addLayerCosts(
        beams, {placement.mate, placement.mateStart, placement.mateHoles, -1, 0, 0, 0}, &costs);
  }
  return costs;
}

//! "At a layer that produces more compact layering" (5.2).
int PaperOperator::pickLayer(const PaperLayout& beams, const PaperPlacement& placement) {
  std::vector<double> costs = layerCosts(beams, placement);
  for (int layer = -kMaxLayer; layer <= kMaxLayer; ++layer) {
    costs[at(layer + kMaxLayer)] +=
        kOffLine * static_cast<double>(layer < 0 ? -layer : layer) + kLayerNoise * rng_->unit();
  }
  return static_cast<int>(std::min_element(costs.begin(), costs.end()) - costs.begin()) - kMaxLayer;
}

//! Draws placements until every edge that became uncovered is covered again.
void PaperOperator::coverAgain(PaperLayout* beams) {
  while (true) {
    const std::vector<PaperPlacement> candidates = beams->placements(beams->touched(), corners_);
    if (candidates.empty()) {
      return;
    }
    std::uint32_t sum = 0;
    for (const PaperPlacement& p : candidates) {
      sum += static_cast<std::uint32_t>(p.covers);
    }
    std::uint32_t draw = rng_->below(sum);
    std::size_t chosen = 0;
    while (draw >= static_cast<std::uint32_t>(candidates[chosen].covers)) {
      draw -= static_cast<std::uint32_t>(candidates[chosen].covers);
      ++chosen;
    }
    beams->add(candidates[chosen], pickLayer(*beams, candidates[chosen]));
  }
}

void PaperOperator::modify(PaperLayout* beams, double turning) {
  for (int pick = 0; pick < kTries; ++pick) {
    const auto [run, edge] = edges_[rng_->below(static_cast<std::uint32_t>(edges_.size()))];
    if (!beams->coverable(run, edge)) {
      continue;
    }
    const std::vector<lattice::Axis>& axes = problem_->graph.runs[at(run)].axes;
    if (turning > 0.0 && axes.size() > 1 && rng_->unit() < turning) {
      beams->turn(run, axes[0] == beams->cover(run).axis ? axes[1] : axes[0]);
    } else {
      beams->removeAround(run, edge);
    }
    coverAgain(beams);
    return;
  }
}

}  // namespace liftarm::search
