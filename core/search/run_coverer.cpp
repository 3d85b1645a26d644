#include "search/run_coverer.h"

#include <algorithm>
#include <cstdlib>

#include "guide/layer_field.h"
#include "layout/axle_collisions.h"
#include "layout/stack.h"

namespace liftarm::search {

namespace {

using guide::kMaxLayer;
using lattice::Axis;
using layout::Beam;
using layout::Cover;
using layout::kLayerCount;

constexpr int kMostOverlap = 3;
constexpr std::uint64_t kOverlapWork = 12;  // of two beams, in beams looked at

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

unsigned bit(int layer) {
  return 1U << static_cast<unsigned>(layer + kMaxLayer);
}

//! How far from its line the first layer is that a run may use.
int nearestAllowed(const guide::GuideRun& run) {
  int layer = 0;
  while (layer < kMaxLayer && !run.allows(layer) && !run.allows(-layer)) {
    ++layer;
  }
  return layer;
}

}  // namespace

RunCoverer::RunCoverer(const layout::LayoutProblem& problem,
                       std::vector<int> lengths,
                       CoverCosts costs)
    : problem_(&problem), allowed_(std::move(lengths)), lengths_(allowed_), costs_(costs) {}

std::size_t RunCoverer::beamIndex(int start, std::size_t length, int layer) const {
  return (at(layer + reach_) * at(edges_ + 2) + at(start + 1)) * lengths_.size() + length;
}

int RunCoverer::stateOf(int last, int layer) const {
  return (last + 1) * kLayerCount + layer + kMaxLayer;
}

bool RunCoverer::mayStart(int start) const {
  return start == 0 || (start == -1 && !exact_) || (start == 1 && mixed_[1] != 0);
}

bool RunCoverer::mayEnd(int last) const {
  return last == edges_ || (last == edges_ + 1 && !exact_) ||
         (last == edges_ - 1 && mixed_[at(edges_ + 1)] != 0);
}

double RunCoverer::stackCost(std::size_t place, unsigned own) const {
  if ((own & unwanted_[place]) != 0U) {
    return costs_.violation;
  }
  const layout::StackFaults faults = layout::stackFaults(otherLayers_[place] | own);
  const int filled = problem_->spacers ? faults.fillable : 0;
  const int with = faults.gaps - filled + faults.overfull;
  return costs_.spacer * static_cast<double>(filled) +
         costs_.violation * stackWeights_[place] * static_cast<double>(with);
}

void RunCoverer::addJunctionCosts(const layout::Layout& layout, int run, Axis axis) {
  const guide::GuideRun& guideRun = problem_->graph.runs[at(run)];
  for (std::size_t j = 0; j < guideRun.junctions.size(); ++j) {
    const guide::Junction& junction = problem_->graph.junctions[at(guideRun.junctions[j])];
    unsigned others = 0;
    bool mixed = false;
    for (const guide::Incidence& incidence : junction.incident) {
      const Cover& cover = layout.run(incidence.run).cover;
      if (incidence.run == run) {
        continue;
      }
      if (cover.axle.used()) {
        mixed = mixed || axis != layout::alongAxisOf(problem_->graph.runs[at(incidence.run)]).axis;
        continue;
      }
      if (cover.axis != axis) {
        mixed = true;
        continue;
      }
      for (const Beam& beam : cover.beams) {
        if (beam.hasHoleAt(incidence.index)) {
          others |= bit(beam.layer);
        }
      }
    }
    const int node = guideRun.junctionIndices[j];
    mixed_[at(node + 1)] = mixed && guide::mayBridge(guideRun, junction) ? 1 : 0;
    junctionPlaces_[at(node + 1)] = static_cast<int>(otherLayers_.size());
    otherLayers_.push_back(others);
    const int wanted = preferred_ == nullptr ? guide::kNoLayer : (*preferred_)[j];
    unwanted_.push_back(wanted == guide::kNoLayer ? 0U : ~bit(wanted));
    stackWeights_.push_back(layout.junctionWeights()[at(guideRun.junctions[j])]);
  }
}

//! What any beam from `firstEnd` or later that starts by `lastStart` would cost more.
void RunCoverer::addToBeams(int layer, int firstEnd, int lastStart, double cost) {
  for (int start = -1; start <= std::min(lastStart, edges_); ++start) {
    double* costs = beamCost_.data() + beamIndex(start, 0, layer);
    for (std::size_t n = 0; n < lengths_.size() && start + lengths_[n] - 1 <= edges_ + 1; ++n) {
      if (start + lengths_[n] - 1 >= firstEnd) {
        costs[n] += cost;
      }
    }
  }
}

void RunCoverer::addBlockers(const layout::Layout& layout, int run, Axis axis) {
  const guide::GuidingGraph& graph = problem_->graph;
  const guide::GuideRun& guideRun = graph.runs[at(run)];
  const int low = -1;
  const int high = edges_ + 1;
  for (const int other : guideRun.near) {
    const Cover& cover = layout.run(other).cover;
    const double weight = 0.5 * (layout.runWeights()[at(run)] + layout.runWeights()[at(other)]);
    rooms_.clear();
    for (const Beam& beam : cover.beams) {
      rooms_.push_back(layout::stadiumOf(graph, graph.runs[at(other)], cover.axis, beam));
    }
    if (cover.axle.used() && !layout::goesThrough(graph, other, run, axis)) {
      rooms_.push_back(layout::roomOf(graph, graph.runs[at(other)], cover.axis, cover.axle));
    }
    for (const layout::Stadium& theirs : rooms_) {
      for (int layer = -reach_; layer <= reach_; ++layer) {
        const auto hits = [&](int first, int last) {
          return overlap(layout::stadiumOf(graph, guideRun, axis, {first, last - first + 1, layer}),
                         theirs);
        };
        work_ += kOverlapWork;
        if (!hits(low, high)) {
          continue;
        }
        // Where beads of the run touch the other beam is an interval: find the first end and the
        // last start that still touch it.
        int firstEnd = low;
        for (int below = high; firstEnd < below;) {
          const int middle = firstEnd + (below - firstEnd) / 2;
          const bool touched = hits(low, middle);
          below = touched ? middle : below;
          firstEnd = touched ? firstEnd : middle + 1;
        }
        int lastStart = high;
        for (int above = low; above < lastStart;) {
          const int middle = lastStart - (lastStart - above) / 2;
          const bool touched = hits(middle, high);
          above = touched ? middle : above;
          lastStart = touched ? lastStart : middle - 1;
        }
        addToBeams(layer, firstEnd, lastStart, costs_.violation * weight);
      }
    }
  }
}

//! By node index + 1: how many nodes before it a beam on this layer may not be at.
void RunCoverer::countForbidden(int run, Axis axis, int layer) {
  const guide::GuidingGraph& graph = problem_->graph;
  forbidden_.assign(at(edges_ + 4), 0);
  const guide::GuideRun& guideRun = graph.runs[at(run)];
  if (!graph.ground.has_value() && graph.keepOut.empty() && guideRun.allows(layer)) {
    return;
  }
  for (int i = -1; i <= edges_ + 1; ++i) {
    const bool bad =
        !guideRun.allows(layer) ||
        layout::forbiddenAt(graph, layout::holePosition(graph, guideRun, axis, i, layer));
    forbidden_[at(i + 2)] = forbidden_[at(i + 1)] + (bad ? 1 : 0);
  }
}

//! What a beam of each length costs on a layer, wherever it lies.
void RunCoverer::setPlainCosts(int layer) {
  plainCosts_.resize(lengths_.size());
  for (std::size_t n = 0; n < lengths_.size(); ++n) {
    plainCosts_[n] = costs_.beam * static_cast<double>(layout::partsOfBeam(lengths_[n])) +
                     costs_.hole * static_cast<double>(lengths_[n]) +
                     costs_.layer * static_cast<double>(layer < 0 ? -layer : layer) +
                     costs_.layerHole * static_cast<double>(lengths_[n] * layer * layer);
    const int place = allowedPlace(n);
    if (place < 0) {
      plainCosts_[n] += kNever;
    } else if (!lengthCosts_.empty()) {
      plainCosts_[n] += lengthCosts_[at(place)];
    }
  }
}

void RunCoverer::addBeamCosts(int run, Axis axis, double noise, base::Rng* rng) {
  nodeCosts_.assign(at(edges_ + 3), 0.0);
  for (int layer = -reach_; layer <= reach_; ++layer) {
    countForbidden(run, axis, layer);
    setPlainCosts(layer);
    for (int node = -1; node <= edges_ + 1; ++node) {
      const int place = junctionPlaces_[at(node + 1)];
      nodeCosts_[at(node + 1)] = place < 0 ? 0.0 : stackCost(at(place), bit(layer));
    }
    for (int start = -1; start <= edges_; ++start) {
      double* costs = beamCost_.data() + beamIndex(start, 0, layer);
      double nodeCosts = 0.0;
      int node = start;
      for (std::size_t n = 0; n < lengths_.size(); ++n) {
        const int last = start + lengths_[n] - 1;
        if (last > edges_ + 1) {
          break;
        }
        for (; node <= last; ++node) {
          nodeCosts += nodeCosts_[at(node + 1)];
        }
        double cost = plainCosts_[n] + nodeCosts + noise * rng->unit();
        cost += start < 0 ? costs_.overhang : 0.0;
        cost += last > edges_ ? costs_.overhang : 0.0;
        cost +=
            kForbidden * static_cast<double>(forbidden_[at(last + 2)] - forbidden_[at(start + 1)]);
        costs[n] += cost;
      }
    }
  }
}

void RunCoverer::prepare(const layout::Layout& layout, int run, Axis axis) {
  const guide::GuideRun& guideRun = problem_->graph.runs[at(run)];
  edges_ = guideRun.edgeCount();
  exact_ = guideRun.exact;
  reach_ = exact_ ? 0 : std::max(wantedReach_, nearestAllowed(guideRun));
  for (const Beam& fixed : fixed_) {
    reach_ = std::max(reach_, std::abs(fixed.layer));
  }
  beamCost_.assign(at(2 * reach_ + 1) * at(edges_ + 2) * lengths_.size(), 0.0);
  value_.assign(at((edges_ + 3) * kLayerCount), kNever);
  choice_.assign(value_.size(), Choice{});
  markCrossedHoles();
  mixed_.assign(at(edges_ + 4), 0);
  junctionPlaces_.assign(at(edges_ + 4), -1);
  otherLayers_.clear();
  stackWeights_.clear();
  unwanted_.clear();
  addJunctionCosts(layout, run, axis);
  addBlockers(layout, run, axis);
}

//! Tries every beam from `start` after `state`; overlapFrom..last of the state are shared nodes.
void RunCoverer::relax(int state, int start, int fromLayer, int overlapFrom) {
  const int previousLast = state < 0 ? start - 1 : state / kLayerCount - 1;
  const double base = state < 0 ? 0.0 : value_[at(state)];
  const int furthest = exact_ ? edges_ : edges_ + 1;
  for (int layer = -reach_; layer <= reach_; ++layer) {
    double joint = 0.0;
    if (state >= 0 && overlapFrom <= previousLast) {
      const bool bridged = overlapFrom == previousLast && mixed_[at(previousLast + 1)] != 0;
      if (layer == fromLayer || (!bridged && layer != fromLayer - 1 && layer != fromLayer + 1)) {
        continue;
      }
      int holes = 0;
      for (int node = overlapFrom; node <= previousLast; ++node) {
        holes += isCrossed(node, layer) || isCrossed(node, fromLayer) ? 0 : 1;
      }
      if (holes == 0) {
        continue;
      }
      joint += holes == 1 ? costs_.hinge : 0.0;
      for (int node = overlapFrom; node <= previousLast; ++node) {
        const int place = junctionPlaces_[at(node + 1)];
        if (place >= 0 && !isCrossed(node, layer) && !isCrossed(node, fromLayer)) {
          joint += stackCost(at(place), bit(layer) | bit(fromLayer)) -
                   stackCost(at(place), bit(layer)) - stackCost(at(place), bit(fromLayer));
        }
      }
    }
    const double* costs = beamCost_.data() + beamIndex(start, 0, layer);
    work_ += lengths_.size();
    for (std::size_t n = 0; n < lengths_.size(); ++n) {
      const int last = start + lengths_[n] - 1;
      if (last > furthest) {
        break;
      }
      const std::size_t next = at(stateOf(last, layer));
      const double value = base + joint + costs[n];
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
  const int behind = choice.previous < 0 ? choice.start : choice.previous / kLayerCount - 1;
  const int fresh = last - std::max(behind, choice.start);
  const int most = std::min({kMostOverlap, fresh, last + 1});
  for (int shared = 1; shared <= most; ++shared) {
    relax(state, last - shared + 1, layer, last - shared + 1);
  }
  const bool here = last >= 0 && mixed_[at(last + 1)] != 0;
  const bool next = mixed_[at(last + 2)] != 0;
  if ((here || next) && last + 1 <= edges_) {
    relax(state, last + 1, layer, last + 1);
  }
  if (next && last + 2 <= edges_) {
    relax(state, last + 2, layer, last + 2);
  }
}

std::optional<Cover> RunCoverer::propose(
    const layout::Layout& layout, int run, Axis axis, double noise, base::Rng* rng) {
  prepare(layout, run, axis);
  addBeamCosts(run, axis, noise, rng);
  favourFixed();
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
  if (best < 0) {
    return std::nullopt;
  }
  Cover cover;
  cover.axis = axis;
  for (int state = best; state >= 0; state = choice_[at(state)].previous) {
    const int last = state / kLayerCount - 1;
    const int layer = state % kLayerCount - kMaxLayer;
    const int start = choice_[at(state)].start;
    cover.beams.push_back({start, last - start + 1, layer});
  }
  std::reverse(cover.beams.begin(), cover.beams.end());
  if (!markFixed(&cover)) {
    return std::nullopt;
  }
  return cover;
}

}  // namespace liftarm::search
