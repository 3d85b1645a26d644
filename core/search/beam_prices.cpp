#include "search/beam_prices.h"

#include <algorithm>

#include "base/index.h"
#include "layout/axle_collisions.h"
#include "search/tuning.h"

namespace liftarm::search {

using base::at;
using layout::Beam;
using layout::Cover;

BeamPrices::BeamPrices(const layout::LayoutProblem& problem,
                       std::vector<int> lengths,
                       CoverCosts costs)
    : problem_(&problem), costs_(costs), allowed_(std::move(lengths)), lengths_(allowed_) {}

void BeamPrices::set(const layout::Layout& layout,
                     const CoverRequest& request,
                     int reach,
                     const JunctionCosts& junctions,
                     base::Rng* rng) {
  edges_ = problem_->graph.runs[at(request.run)].edgeCount();
  reach_ = reach;
  setLengths(request.fixed);
  prices_.assign(at(2 * reach_ + 1) * at(edges_ + 2) * lengths_.size(), 0.0);
  addBlockers(layout, request);
  addBeams(request, junctions, rng);
  forbidUnwanted(request.run);
  favour(request.fixed);
}

void BeamPrices::setLengths(std::span<const Beam> fixed) {
  lengths_ = allowed_;
  for (const Beam& beam : fixed) {
    const auto place = std::lower_bound(lengths_.begin(), lengths_.end(), beam.holes);
    if (place == lengths_.end() || *place != beam.holes) {
      lengths_.insert(place, beam.holes);
    }
  }
}

//! Place of a length among those allowed, or -1.
int BeamPrices::allowedPlace(std::size_t length) const {
  if (lengths_.size() == allowed_.size()) {
    return static_cast<int>(length);
  }
  const auto found = std::find(allowed_.begin(), allowed_.end(), lengths_[length]);
  return found == allowed_.end() ? -1 : static_cast<int>(found - allowed_.begin());
}

//! What any beam from `firstEnd` or later that starts by `lastStart` would cost more.
void BeamPrices::addToBeams(int layer, int firstEnd, int lastStart, double cost) {
  for (int start = -1; start <= std::min(lastStart, edges_); ++start) {
    double* costs = prices_.data() + index(start, 0, layer);
    for (std::size_t n = 0; n < lengths_.size() && start + lengths_[n] - 1 <= edges_ + 1; ++n) {
      if (start + lengths_[n] - 1 >= firstEnd) {
        costs[n] += cost;
      }
    }
  }
}

void BeamPrices::addBlockers(const layout::Layout& layout, const CoverRequest& request) {
  const guide::GuidingGraph& graph = problem_->graph;
  for (const int other : graph.runs[at(request.run)].near) {
    const guide::GuideRun& otherRun = graph.runs[at(other)];
    const Cover& cover = layout.run(other).cover;
    const double weight =
        0.5 * (layout.runWeights()[at(request.run)] + layout.runWeights()[at(other)]);
    rooms_.clear();
    for (const Beam& beam : cover.beams) {
      rooms_.push_back(layout::stadiumOf(graph, otherRun, cover.axis, beam));
    }
    if (cover.axle.used() && !layout::goesThrough(graph, other, request.run, request.axis)) {
      rooms_.push_back(layout::roomOf(graph, otherRun, cover.axis, cover.axle));
    }
    for (const layout::Stadium& room : rooms_) {
      addBlocker(request, room, costs_.violation * weight);
    }
  }
}

//! What beams that would touch a room cost more, on each layer.
void BeamPrices::addBlocker(const CoverRequest& request, const layout::Stadium& room, double cost) {
  const guide::GuidingGraph& graph = problem_->graph;
  const guide::GuideRun& run = graph.runs[at(request.run)];
  const int low = -1;
  const int high = edges_ + 1;
  for (int layer = -reach_; layer <= reach_; ++layer) {
    const auto hits = [&](int first, int last) {
      return overlap(layout::stadiumOf(graph, run, request.axis, {first, last - first + 1, layer}),
                     room);
    };
    work_ += kTuning.covers.overlapWork;
    if (!hits(low, high)) {
      continue;
    }
    // Where beads of the run touch the room is an interval: find the first end and the last start
    // that still touch it.
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
    addToBeams(layer, firstEnd, lastStart, cost);
  }
}

//! By node index + 1: how many nodes before it a beam on this layer may not be at.
void BeamPrices::countForbidden(const CoverRequest& request, int layer) {
  const guide::GuidingGraph& graph = problem_->graph;
  forbidden_.assign(at(edges_ + 4), 0);
  const guide::GuideRun& run = graph.runs[at(request.run)];
  if (!graph.ground.has_value() && graph.keepOut.empty() && run.allows(layer)) {
    return;
  }
  for (int i = -1; i <= edges_ + 1; ++i) {
    const bool bad =
        !run.allows(layer) ||
        layout::forbiddenAt(graph, layout::holePosition(graph, run, request.axis, i, layer));
    forbidden_[at(i + 2)] = forbidden_[at(i + 1)] + (bad ? 1 : 0);
  }
}

//! What a beam of each length costs on a layer, wherever it lies.
void BeamPrices::setPlain(const CoverRequest& request, int layer) {
  plain_.resize(lengths_.size());
  for (std::size_t n = 0; n < lengths_.size(); ++n) {
    plain_[n] = costs_.beam * static_cast<double>(layout::partsOfBeam(lengths_[n])) +
                costs_.hole * static_cast<double>(lengths_[n]) +
                costs_.layer * static_cast<double>(layer < 0 ? -layer : layer) +
                costs_.layerHole * static_cast<double>(lengths_[n] * layer * layer);
    const int place = allowedPlace(n);
    if (place < 0) {
      plain_[n] += kTuning.covers.never;
    } else if (!request.lengthCosts.empty()) {
      plain_[n] += request.lengthCosts[at(place)];
    }
  }
}

void BeamPrices::addBeams(const CoverRequest& request,
                          const JunctionCosts& junctions,
                          base::Rng* rng) {
  nodes_.assign(at(edges_ + 3), 0.0);
  for (int layer = -reach_; layer <= reach_; ++layer) {
    countForbidden(request, layer);
    setPlain(request, layer);
    for (int node = -1; node <= edges_ + 1; ++node) {
      const int place = junctions.placeOf(node);
      nodes_[at(node + 1)] = place < 0 ? 0.0 : junctions.cost(place, layerBit(layer));
    }
    addLayer(layer, request.manner.noise, rng);
  }
}

//! Adds to all beams of a layer what they cost there, each with a random amount.
void BeamPrices::addLayer(int layer, double noise, base::Rng* rng) {
  for (int start = -1; start <= edges_; ++start) {
    double* costs = prices_.data() + index(start, 0, layer);
    double nodeCosts = 0.0;
    int node = start;
    for (std::size_t n = 0; n < lengths_.size(); ++n) {
      const int last = start + lengths_[n] - 1;
      if (last > edges_ + 1) {
        break;
      }
      for (; node <= last; ++node) {
        nodeCosts += nodes_[at(node + 1)];
      }
      double cost = plain_[n] + nodeCosts + noise * rng->unit();
      cost += start < 0 ? costs_.overhang : 0.0;
      cost += last > edges_ ? costs_.overhang : 0.0;
      cost += kTuning.covers.forbidden *
              static_cast<double>(forbidden_[at(last + 2)] - forbidden_[at(start + 1)]);
      costs[n] += cost;
    }
  }
}

//! Makes beams impossible that the sketch does not want on a run.
void BeamPrices::forbidUnwanted(int run) {
  const layout::RunKeep* keep = problem_->keepOf(run);
  if (keep == nullptr) {
    return;
  }
  for (int layer = -reach_; layer <= reach_; ++layer) {
    for (int start = -1; start <= edges_; ++start) {
      for (std::size_t n = 0; n < lengths_.size() && start + lengths_[n] - 1 <= edges_ + 1; ++n) {
        if (!keep->permits({start, lengths_[n], layer}, problem_->sites)) {
          prices_[index(start, n, layer)] += kTuning.covers.forbidden;
        }
      }
    }
  }
}

void BeamPrices::favour(std::span<const Beam> fixed) {
  const CoverTuning& tuning = kTuning.covers;
  for (const Beam& beam : fixed) {
    for (int start = -1; start <= edges_; ++start) {
      for (std::size_t n = 0; n < lengths_.size(); ++n) {
        const int last = start + lengths_[n] - 1;
        double& price = prices_[index(start, n, beam.layer)];
        if (start == beam.start && lengths_[n] == beam.holes) {
          price -= allowedPlace(n) < 0 ? tuning.never + tuning.fixedBonus : tuning.fixedBonus;
        } else if (last <= edges_ + 1 && start <= beam.solidLast() && last >= beam.solidStart()) {
          price += tuning.forbidden;
        }
      }
    }
  }
}

}  // namespace liftarm::search
