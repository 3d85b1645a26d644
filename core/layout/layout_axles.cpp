#include <algorithm>
#include <set>

#include "base/index.h"
#include "layout/axle_collisions.h"
#include "layout/layout.h"

// What a layout has to do with axles that cover runs. Where there is none, nothing of this is
// asked.

namespace liftarm::layout {

namespace {

using base::at;
using lattice::Cell;

//! Node index of a run in the junction, -1 when it does not pass there.
int indexAt(const guide::Junction& junction, int run) {
  for (const guide::Incidence& incidence : junction.incident) {
    if (incidence.run == run) {
      return incidence.index;
    }
  }
  return -1;
}

}  // namespace

void Layout::addAxle(const Axle& axle, int sign) {
  tallies_.axles += sign;
  tallies_.connectors += sign * (1 + axle.bushCount());
  tallies_.mechanisms += sign;
  tallies_.mechanismHeads += sign * axle.headCount();
  tallies_.mechanismCells += sign * axle.length();
  tallies_.pinHeadRatios += static_cast<double>(sign) * static_cast<double>(axle.headCount()) /
                            static_cast<double>(axle.length());
  tallies_.connectionCost += static_cast<double>(sign) * axle.cost();
}

std::uint64_t Layout::seatsOn(int run) const {
  const guide::GuideRun& guideRun = problem_->graph.runs[at(run)];
  const AlongAxis along = alongAxisOf(guideRun);
  std::uint64_t seats = 0;
  for (std::size_t j = 0; j < guideRun.junctions.size(); ++j) {
    const guide::Junction& junction = problem_->graph.junctions[at(guideRun.junctions[j])];
    for (const guide::Incidence& incidence : junction.incident) {
      const Cover& cover = runs_[at(incidence.run)].cover;
      if (incidence.run == run || cover.axis != along.axis) {
        continue;
      }
      for (const Beam& beam : cover.beams) {
        const int seat = guideRun.junctionIndices[j] + along.sign * beam.layer;
        if (beam.hasHoleAt(incidence.index) && seat >= -kAxleReach &&
            seat <= guideRun.edgeCount() + kAxleReach) {
          seats |= std::uint64_t{1} << axleBit(seat);
        }
      }
    }
  }
  return seats;
}

AxleSite Layout::axleSite(int run) const {
  const guide::GuidingGraph& graph = problem_->graph;
  const guide::GuideRun& guideRun = graph.runs[at(run)];
  AxleSite site{guideRun.edgeCount(), seatsOn(run), 0};
  if (graph.ground || !graph.keepOut.empty()) {
    for (int i = -kAxleReach; i <= site.edges + kAxleReach; ++i) {
      const bool bad = forbiddenAt(graph, holePosition(graph, guideRun, guideRun.axes[0], i, 0));
      site.forbidden |= bad ? std::uint64_t{1} << axleBit(i) : 0U;
    }
  }
  return site;
}

bool Layout::onAxle(int junction) const {
  if (tallies_.axles == 0) {
    return false;
  }
  const std::vector<guide::Incidence>& incident = problem_->graph.junctions[at(junction)].incident;
  return std::any_of(incident.begin(), incident.end(), [&](const guide::Incidence& incidence) {
    return runs_[at(incidence.run)].cover.axle.used();
  });
}

void Layout::addAxleTerminals(int junction) {
  for (const guide::Incidence& incidence : problem_->graph.junctions[at(junction)].incident) {
    if (runs_[at(incidence.run)].cover.axle.used() &&
        localTerminals_.size() < LocalProblem::kMaxTerminals) {
      localTerminals_.emplace_back(incidence.run, -1);
    }
  }
}

//! Enters all axles near a junction; the holes that they fill are used.
void Layout::fillAxles(int junction) {
  if (tallies_.axles == 0) {
    return;
  }
  const guide::GuidingGraph& graph = problem_->graph;
  const lattice::Vec3 origin = graph.nodes[at(graph.junctions[at(junction)].node)];
  for (const RunView& view : problem_->views[at(junction)].runs) {
    const Cover& cover = runs_[at(view.run)].cover;
    if (!cover.axle.used()) {
      continue;
    }
    const std::uint64_t seats = seatsOn(view.run);
    for (int i = cover.axle.start; i <= cover.axle.last(); ++i) {
      if (!view.aligned) {
        local_.blockAround(holePosition(graph, graph.runs[at(view.run)], cover.axis, i, 0) -
                           origin);
        continue;
      }
      const Cell cell = view.base + Cell{i * view.step.x, i * view.step.y, i * view.step.z};
      if (!inBox(cell)) {
        continue;
      }
      if (hasAxleBit(seats, i) && !cover.axle.hasBush(i)) {
        local_.useHole(boxIndex(cell));
      } else {
        local_.block(boxIndex(cell));
      }
    }
  }
}

//! Joins the terminals that an axle through the junction holds, and counts those that turn on it.
void Layout::joinOnAxles(int junction) {
  localLoose_ = 0;
  const guide::Junction& guideJunction = problem_->graph.junctions[at(junction)];
  for (std::size_t t = 0; t < localTerminals_.size(); ++t) {
    const int run = localTerminals_[t].first;
    if (localTerminals_[t].second >= 0) {
      continue;
    }
    const AlongAxis along = alongAxisOf(problem_->graph.runs[at(run)]);
    if (local_.isJoint && local_.jointAxis != along.axis) {
      continue;
    }
    const std::uint64_t held = heldOn(runs_[at(run)].cover.axle, seatsOn(run));
    std::set<int> groups;
    std::set<std::pair<int, int>> bodies;
    std::vector<int> joined;
    for (std::size_t u = 0; u < localTerminals_.size(); ++u) {
      const auto [other, b] = localTerminals_[u];
      const Cover& cover = runs_[at(other)].cover;
      if (b < 0 || cover.axis != along.axis) {
        continue;
      }
      const Beam& beam = cover.beams[at(b)];
      const int index = indexAt(guideJunction, other);
      if (beam.hasHoleAt(index) &&
          hasAxleBit(held, indexAt(guideJunction, run) + along.sign * beam.layer)) {
        const int group = local_.isJoint ? local_.group[u] : 0;
        groups.insert(group);
        bodies.emplace(group, local_.cluster[u]);
        joined.push_back(static_cast<int>(u));
      }
    }
    localLoose_ += static_cast<int>(bodies.size() - groups.size());
    for (const int u : joined) {
      local_.join(static_cast<int>(t), u);
    }
  }
}

//! Where a beam on an axle moves, others on it may slide.
void Layout::findStaleOnAxles() {
  for (const auto& [run, before] : savedRuns_) {
    if (before.cover == runs_[at(run)].cover) {
      continue;
    }
    for (const int met : problem_->graph.runs[at(run)].junctions) {
      for (const guide::Incidence& incidence : problem_->graph.junctions[at(met)].incident) {
        if (!runs_[at(incidence.run)].cover.axle.used()) {
          continue;
        }
        for (const int junction : problem_->graph.runs[at(incidence.run)].junctions) {
          if (stale_[at(junction)] == 0) {
            stale_[at(junction)] = 1;
            staleList_.push_back(junction);
          }
        }
      }
    }
  }
}

//! On an axle as many beams may be stacked as it holds, and bushes fill gaps. Counts that stack and
//! takes it from the others.
void Layout::countStackOnAxle(int junction,
                              std::array<unsigned, 3>* layers,
                              JunctionState* state) const {
  for (const guide::Incidence& incidence : problem_->graph.junctions[at(junction)].incident) {
    const Axle& axle = runs_[at(incidence.run)].cover.axle;
    if (!axle.used()) {
      continue;
    }
    const AlongAxis along = alongAxisOf(problem_->graph.runs[at(incidence.run)]);
    unsigned& stack = (*layers)[at(lattice::index(along.axis))];
    bool any = false;
    int gaps = 0;
    for (int layer = -guide::kMaxLayer; layer <= guide::kMaxLayer; ++layer) {
      const bool beam = (stack >> static_cast<unsigned>(layer + guide::kMaxLayer) & 1U) != 0U;
      state->gaps += beam && any ? gaps : 0;
      any = any || beam;
      gaps = beam ? 0 : gaps + (axle.hasBush(incidence.index + along.sign * layer) ? 0 : 1);
    }
    stack = 0;
  }
}

}  // namespace liftarm::layout
