#include "search/run_coverer.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>

#include "base/index.h"
#include "search/tuning.h"

namespace liftarm::search {

namespace {

using base::at;
using guide::kMaxLayer;
using layout::Beam;
using layout::Cover;
using layout::kLayerCount;

constexpr double kNever = kTuning.covers.never;

int stateOf(int last, int layer) {
  return (last + 1) * kLayerCount + layer + kMaxLayer;
}

int lastOf(int state) {
  return state / kLayerCount - 1;
}

//! How far from its line the first layer is that a run may use.
int nearestAllowed(const guide::GuideRun& run) {
  int layer = 0;
  while (layer < kMaxLayer && !run.allows(layer) && !run.allows(-layer)) {
    ++layer;
  }
  return layer;
}

//! Marks the arms of bent beams in a cover; false when one is missing, or its axle hole's place is
//! taken.
bool markFixed(std::span<const Beam> fixed, Cover* cover) {
  return std::all_of(fixed.begin(), fixed.end(), [&](const Beam& wanted) {
    bool found = false;
    for (Beam& beam : cover->beams) {
      if (beam.start == wanted.start && beam.holes == wanted.holes && beam.layer == wanted.layer) {
        beam = wanted;
        found = true;
      } else if (beam.layer == wanted.layer && beam.solidStart() <= wanted.solidLast() &&
                 beam.solidLast() >= wanted.solidStart()) {
        return false;
      }
    }
    return found;
  });
}

//! Beams that a cover must contain, and those that the sketch keeps there.
std::vector<Beam> withKept(std::span<const Beam> fixed, const layout::RunKeep* keep) {
  std::vector<Beam> all(fixed.begin(), fixed.end());
  if (keep != nullptr) {
    std::copy_if(
        keep->beams.begin(), keep->beams.end(), std::back_inserter(all), [&](const Beam& beam) {
          return std::find(fixed.begin(), fixed.end(), beam) == fixed.end();
        });
  }
  return all;
}

}  // namespace

RunCoverer::RunCoverer(const layout::LayoutProblem& problem,
                       std::vector<int> lengths,
                       CoverCosts costs)
    : problem_(&problem),
      costs_(costs),
      junctions_(problem, costs),
      prices_(problem, std::move(lengths), costs) {}

bool RunCoverer::mayStart(int start) const {
  return start == 0 || (start == -1 && !exact_) || (start == 1 && junctions_.mayBridge(0));
}

bool RunCoverer::mayEnd(int last) const {
  return last == edges_ || (last == edges_ + 1 && !exact_) ||
         (last == edges_ - 1 && junctions_.mayBridge(edges_));
}

void RunCoverer::prepare(const layout::Layout& layout,
                         const CoverRequest& request,
                         base::Rng* rng) {
  const guide::GuideRun& run = problem_->graph.runs[at(request.run)];
  edges_ = run.edgeCount();
  exact_ = run.exact;
  reach_ = exact_ ? 0 : std::max(request.manner.reach, nearestAllowed(run));
  for (const Beam& beam : request.fixed) {
    reach_ = std::max(reach_, std::abs(beam.layer));
  }
  value_.assign(at((edges_ + 3) * kLayerCount), kNever);
  choice_.assign(value_.size(), Choice{});
  markCrossedHoles(request.fixed);
  junctions_.prepare(layout, request);
  prices_.set(layout, request, reach_, junctions_, rng);
}

//! Notes where no beam can be pinned to a fixed one.
void RunCoverer::markCrossedHoles(std::span<const Beam> fixed) {
  crossed_.clear();
  for (const Beam& beam : fixed) {
    for (int node = beam.start; node <= beam.last() && beam.crossed != 0; ++node) {
      crossed_.resize(value_.size(), 0);
      crossed_[at(stateOf(node, beam.layer))] = beam.hasHoleAt(node) ? 0 : 1;
    }
  }
}

bool RunCoverer::isCrossed(int node, int layer) const {
  return !crossed_.empty() && crossed_[at(stateOf(node, layer))] != 0;
}

//! What it costs more that two beams in line share the nodes first .. last, as a hinge and in the
//! stacks there; nothing where they cannot be pinned to each other.
std::optional<double> RunCoverer::jointCost(int first, int last, int fromLayer, int layer) const {
  const bool bridged = first == last && junctions_.mayBridge(last);
  if (layer == fromLayer || (!bridged && layer != fromLayer - 1 && layer != fromLayer + 1)) {
    return std::nullopt;
  }
  int holes = 0;
  for (int node = first; node <= last; ++node) {
    holes += isCrossed(node, layer) || isCrossed(node, fromLayer) ? 0 : 1;
  }
  if (holes == 0) {
    return std::nullopt;
  }
  double joint = holes == 1 ? costs_.hinge : 0.0;
  for (int node = first; node <= last; ++node) {
    const int place = junctions_.placeOf(node);
    if (place >= 0 && !isCrossed(node, layer) && !isCrossed(node, fromLayer)) {
      joint += junctions_.cost(place, layerBit(layer) | layerBit(fromLayer)) -
               junctions_.cost(place, layerBit(layer)) -
               junctions_.cost(place, layerBit(fromLayer));
    }
  }
  return joint;
}

//! Tries every beam from `start` after `state`; overlapFrom..last of the state are shared nodes.
void RunCoverer::relax(int state, int start, int fromLayer, int overlapFrom) {
  const int previousLast = state < 0 ? start - 1 : lastOf(state);
  const double base = state < 0 ? 0.0 : value_[at(state)];
  const int furthest = exact_ ? edges_ : edges_ + 1;
  const std::vector<int>& lengths = prices_.lengths();
  for (int layer = -reach_; layer <= reach_; ++layer) {
    double joint = 0.0;
    if (state >= 0 && overlapFrom <= previousLast) {
      const std::optional<double> cost = jointCost(overlapFrom, previousLast, fromLayer, layer);
      if (!cost) {
        continue;
      }
      joint = *cost;
    }
    const double* prices = prices_.from(start, layer);
    work_ += lengths.size();
    for (std::size_t n = 0; n < lengths.size(); ++n) {
      const int last = start + lengths[n] - 1;
      if (last > furthest) {
        break;
      }
      const std::size_t next = at(stateOf(last, layer));
      const double value = base + joint + prices[n];
      if (last > previousLast && value < value_[next]) {
        value_[next] = value;
        choice_[next] = {state, start};
      }
    }
  }
}

void RunCoverer::extendFrom(int last, int layer) {
  const int state = stateOf(last, layer);
  if (value_[at(state)] >= kNever || last >= edges_) {
    return;
  }
  // The beam after next may be on this layer again: it must not reach back to the beam before.
  const Choice& choice = choice_[at(state)];
  const int behind = choice.previous < 0 ? choice.start : lastOf(choice.previous);
  const int fresh = last - std::max(behind, choice.start);
  const int most = std::min({kTuning.covers.mostOverlap, fresh, last + 1});
  for (int shared = 1; shared <= most; ++shared) {
    relax(state, last - shared + 1, layer, last - shared + 1);
  }
  const bool here = last >= 0 && junctions_.mayBridge(last);
  const bool next = junctions_.mayBridge(last + 1);
  if ((here || next) && last + 1 <= edges_) {
    relax(state, last + 1, layer, last + 1);
  }
  if (next && last + 2 <= edges_) {
    relax(state, last + 2, layer, last + 2);
  }
}

//! Spreads costs from node to node. \return The cheapest state that may be the last; -1: none.
int RunCoverer::cheapestEnd() {
  for (int start = -1; start <= 1 && start < edges_ + 1; ++start) {
    if (mayStart(start)) {
      relax(-1, start, 0, start);
    }
  }
  int best = -1;
  for (int last = 0; last <= edges_ + 1; ++last) {
    for (int layer = -reach_; layer <= reach_; ++layer) {
      extendFrom(last, layer);
      const int state = stateOf(last, layer);
      if (mayEnd(last) && value_[at(state)] < kNever &&
          (best < 0 || value_[at(state)] < value_[at(best)])) {
        best = state;
      }
    }
  }
  return best;
}

Cover RunCoverer::coverTo(int state, lattice::Axis axis) const {
  Cover cover;
  cover.axis = axis;
  for (; state >= 0; state = choice_[at(state)].previous) {
    const int last = lastOf(state);
    const int layer = state % kLayerCount - kMaxLayer;
    const int start = choice_[at(state)].start;
    cover.beams.push_back({start, last - start + 1, layer});
  }
  std::reverse(cover.beams.begin(), cover.beams.end());
  return cover;
}

std::optional<Cover> RunCoverer::propose(const layout::Layout& layout,
                                         const CoverRequest& asked,
                                         base::Rng* rng) {
  CoverRequest request = asked;
  const std::vector<Beam> fixed = withKept(asked.fixed, problem_->keepOf(asked.run));
  request.fixed = fixed;
  prepare(layout, request, rng);
  const int end = cheapestEnd();
  if (end < 0) {
    return std::nullopt;
  }
  Cover cover = coverTo(end, request.axis);
  if (!markFixed(request.fixed, &cover)) {
    return std::nullopt;
  }
  return cover;
}

}  // namespace liftarm::search
