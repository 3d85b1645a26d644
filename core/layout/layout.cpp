#include "layout/layout.h"

#include <algorithm>
#include <array>

#include "base/check.h"
#include "base/index.h"
#include "layout/axle_collisions.h"
#include "layout/stack.h"
#include "mechanisms/mechanism_table.h"

namespace liftarm::layout {

namespace {

using base::at;
using lattice::Axis;
using lattice::Cell;

// What nothing but an axle holds has not even a pin's friction.
constexpr int kLooseHinges = 2;

}  // namespace

LayoutProblem makeLayoutProblem(guide::GuidingGraph graph, bool spacers) {
  LayoutProblem problem;
  problem.spacers = spacers;
  problem.views = buildLocalViews(graph);
  problem.seenBy.resize(graph.runs.size());
  for (std::size_t j = 0; j < problem.views.size(); ++j) {
    for (std::size_t v = 0; v < problem.views[j].runs.size(); ++v) {
      problem.seenBy[at(problem.views[j].runs[v].run)].emplace_back(static_cast<int>(j),
                                                                    static_cast<int>(v));
    }
  }
  problem.sites = findFrameSites(graph, problem.views, problem.seenBy);
  problem.graph = std::move(graph);
  return problem;
}

Layout::Layout(const LayoutProblem& problem, ConnectionSolver& solver)
    : problem_(&problem),
      solver_(&solver),
      runs_(problem.graph.runs.size()),
      junctions_(problem.graph.junctions.size()),
      junctionWeights_(problem.graph.junctions.size(), 1.0),
      runWeights_(problem.graph.runs.size(), 1.0),
      runSaved_(problem.graph.runs.size(), 0),
      junctionSaved_(problem.graph.junctions.size(), 0),
      stale_(problem.graph.junctions.size(), 0) {
  for (std::size_t r = 0; r < runs_.size(); ++r) {
    runs_[r].cover.axis = problem.graph.runs[r].axes.front();
  }
}

BeamShare Layout::shareOf(int run, const Beam& beam) const {
  if (beam.site >= 0) {
    const FrameSite& site = problem_->sites[at(beam.site)];
    return {site.arms.front().run == run ? 1 : 0, armOn(site, run).own};
  }
  if (beam.mate >= 0) {
    return beam.mate < run ? BeamShare{0, beam.holes - 1} : BeamShare{1, beam.holes};
  }
  return {partsOfBeam(beam.holes), beam.holes};
}

void Layout::addRun(const RunState& state, int run, int sign) {
  const guide::GuideRun& guideRun = problem_->graph.runs[at(run)];
  for (std::size_t b = 0; b < state.cover.beams.size(); ++b) {
    const Beam& beam = state.cover.beams[b];
    const auto [parts, holes] = shareOf(run, beam);
    tallies_.beams += sign * parts;
    tallies_.holes += sign * holes;
    tallies_.layerSquares += sign * holes * beam.layer * beam.layer;
    tallies_.overhang += sign * ((beam.solidStart() < 0 ? 1 : 0) +
                                 (beam.solidLast() > guideRun.edgeCount() ? 1 : 0));
    if (b > 0) {
      const Beam& before = state.cover.beams[b - 1];
      const int shared = sharedHoles(before, beam);
      const auto pins = inlinePins(guideRun, before, beam).count;
      tallies_.hinges += sign * (shared == 1 ? 1 : 0);
      tallies_.connectors += sign * pins;
      tallies_.mechanisms += sign * pins;
      tallies_.mechanismHeads += sign * 2 * pins;
      tallies_.mechanismCells += sign * 2 * pins;
      tallies_.pinHeadRatios += static_cast<double>(sign * pins);
      tallies_.connectionCost += static_cast<double>(sign * pins);
    }
  }
  if (state.cover.axle.used()) {
    addAxle(state.cover.axle, sign);
  }
  tallies_.forbidden += sign * state.forbidden;
  weighted_ += static_cast<double>(sign * state.forbidden) * runWeights_[at(run)];
}

void Layout::addJunction(const JunctionState& state, int junction, int sign) {
  tallies_.gaps += sign * state.gaps;
  tallies_.overfull += sign * state.overfull;
  tallies_.hinges += sign * kLooseHinges * state.loose;
  tallies_.failedConnections += sign * state.connection.failed;
  tallies_.connectionCost +=
      static_cast<double>(sign) *
      (state.connection.cost + kSpacerCost * static_cast<double>(state.spacers.size()));
  tallies_.connectors += sign * static_cast<int>(state.spacers.size());
  for (const PlacedMechanism& placed : state.connection.mechanisms) {
    const mechanisms::OrientedMechanism& m = table().oriented(placed.oriented);
    tallies_.connectors += sign * static_cast<int>(m.shape.parts.size());
    tallies_.mechanisms += sign;
    tallies_.mechanismHeads += sign * m.heads;
    tallies_.mechanismCells += sign * static_cast<int>(m.shape.cells.size());
    tallies_.pinHeadRatios += static_cast<double>(sign) * m.shape.pinHeadRatio();
  }
  weighted_ += static_cast<double>(sign * state.violations()) * junctionWeights_[at(junction)];
}

int Layout::collisionsWith(int run, const Cover& cover, int other) const {
  const guide::GuidingGraph& graph = problem_->graph;
  const Cover& otherCover = runs_[at(other)].cover;
  int pairs = 0;
  for (const Beam& beam : cover.beams) {
    const Stadium mine = stadiumOf(graph, graph.runs[at(run)], cover.axis, beam);
    for (const Beam& otherBeam : otherCover.beams) {
      if (isOneBeam(run, beam, other, otherBeam)) {
        continue;
      }
      pairs += overlap(mine, stadiumOf(graph, graph.runs[at(other)], otherCover.axis, otherBeam))
                   ? 1
                   : 0;
    }
  }
  if (cover.axle.used() || otherCover.axle.used()) {
    pairs += axleCollisions(graph, run, cover, other, otherCover);
  }
  return pairs;
}

int Layout::forbiddenOf(int run, const Cover& cover) const {
  const guide::GuidingGraph& graph = problem_->graph;
  const guide::GuideRun& guideRun = graph.runs[at(run)];
  int count = keepViolations(*problem_, run, cover);
  for (const Beam& beam : cover.beams) {
    count += guideRun.allows(beam.layer) ? 0 : beam.holes;
  }
  for (std::size_t b = 1; b < cover.beams.size(); ++b) {
    const Beam& before = cover.beams[b - 1];
    const bool overlap = before.last() >= cover.beams[b].start;
    count += overlap && sharedHoles(before, cover.beams[b]) == 0 ? 1 : 0;
  }
  for (int i = cover.axle.start; i <= cover.axle.last() && cover.axle.used(); ++i) {
    count += forbiddenAt(graph, holePosition(graph, graph.runs[at(run)], cover.axis, i, 0)) ? 1 : 0;
  }
  if (!graph.ground && graph.keepOut.empty()) {
    return count;
  }
  for (const Beam& beam : cover.beams) {
    for (int i = beam.solidStart(); i <= beam.solidLast(); ++i) {
      count +=
          forbiddenAt(graph, holePosition(graph, graph.runs[at(run)], cover.axis, i, beam.layer))
              ? 1
              : 0;
    }
  }
  return count;
}

void Layout::changeCollisions(int run, int delta) {
  if (delta != 0) {
    if (runSaved_[at(run)] == 0) {
      runSaved_[at(run)] = 1;
      savedRuns_.emplace_back(run, runs_[at(run)]);
    }
    runs_[at(run)].collisions += delta;
    weighted_ += 0.5 * static_cast<double>(delta) * runWeights_[at(run)];
  }
}

//! Before the first edit since keep().
void Layout::saveTallies() {
  if (savedRuns_.empty() && savedJunctions_.empty()) {
    savedTallies_ = tallies_;
    savedWeighted_ = weighted_;
  }
}

void Layout::setCover(int run, Cover cover) {
  RunState& state = runs_[at(run)];
  saveTallies();
  if (runSaved_[at(run)] == 0) {
    runSaved_[at(run)] = 1;
    savedRuns_.emplace_back(run, state);
  }
  for (const int other : problem_->graph.runs[at(run)].near) {
    if (runs_[at(other)].cover.empty()) {
      continue;
    }
    const int delta = collisionsWith(run, cover, other) - collisionsWith(run, state.cover, other);
    tallies_.collisions += delta;
    changeCollisions(other, delta);
    changeCollisions(run, delta);
  }
  addRun(state, run, -1);
  state.cover = std::move(cover);
  state.forbidden = forbiddenOf(run, state.cover);
  addRun(state, run, 1);
}

void Layout::saveJunction(int junction) {
  if (junctionSaved_[at(junction)] == 0) {
    junctionSaved_[at(junction)] = 1;
    savedJunctions_.emplace_back(junction, junctions_[at(junction)]);
  }
}

void Layout::settleAll() {
  for (std::size_t j = 0; j < junctions_.size(); ++j) {
    if (stale_[j] == 0) {
      stale_[j] = 1;
      staleList_.push_back(static_cast<int>(j));
    }
  }
  saveTallies();
  settle();
}

void Layout::restore(const std::vector<Cover>& covers,
                     const std::vector<JunctionState>& junctions) {
  for (std::size_t r = 0; r < covers.size(); ++r) {
    setCover(static_cast<int>(r), covers[r]);
  }
  for (std::size_t j = 0; j < junctions.size(); ++j) {
    addJunction(junctions_[j], static_cast<int>(j), -1);
    junctions_[j] = junctions[j];
    addJunction(junctions_[j], static_cast<int>(j), 1);
  }
  keep();
}

void Layout::keep() {
  LIFTARM_CHECK(staleList_.empty(), "keep() before settle()");
  for (const auto& saved : savedRuns_) {
    runSaved_[at(saved.first)] = 0;
  }
  for (const auto& saved : savedJunctions_) {
    junctionSaved_[at(saved.first)] = 0;
  }
  savedRuns_.clear();
  savedJunctions_.clear();
}

void Layout::revert() {
  for (const int junction : staleList_) {
    stale_[at(junction)] = 0;
  }
  staleList_.clear();
  const bool changed = !savedRuns_.empty() || !savedJunctions_.empty();
  for (auto& [run, state] : savedRuns_) {
    runs_[at(run)] = std::move(state);
    runSaved_[at(run)] = 0;
  }
  for (auto& [junction, state] : savedJunctions_) {
    junctions_[at(junction)] = std::move(state);
    junctionSaved_[at(junction)] = 0;
  }
  savedRuns_.clear();
  savedJunctions_.clear();
  if (changed) {
    tallies_ = savedTallies_;
    weighted_ = savedWeighted_;
  }
}

void Layout::setWeights(std::vector<double> junctionWeights, std::vector<double> runWeights) {
  junctionWeights_ = std::move(junctionWeights);
  runWeights_ = std::move(runWeights);
  weighted_ = 0.0;
  for (std::size_t j = 0; j < junctions_.size(); ++j) {
    weighted_ += static_cast<double>(junctions_[j].violations()) * junctionWeights_[j];
  }
  for (std::size_t r = 0; r < runs_.size(); ++r) {
    weighted_ +=
        (0.5 * static_cast<double>(runs_[r].collisions) + static_cast<double>(runs_[r].forbidden)) *
        runWeights_[r];
  }
}

Tallies Layout::recount() const {
  Layout fresh(*problem_, *solver_);
  for (std::size_t r = 0; r < runs_.size(); ++r) {
    fresh.setCover(static_cast<int>(r), runs_[r].cover);
  }
  for (std::size_t j = 0; j < junctions_.size(); ++j) {
    fresh.addJunction(junctions_[j], static_cast<int>(j), 1);
  }
  return fresh.tallies_;
}

int Layout::stackViolationsAt(int junction) const {
  JunctionState state;
  countStack(junction, &state);
  return state.gaps + state.overfull;
}

void Layout::countStack(int junction, JunctionState* state) const {
  state->gaps = 0;
  state->overfull = 0;
  state->spacers.clear();
  std::array<unsigned, 3> layers{};  // in use, by hole axis
  for (const guide::Incidence& incidence : problem_->graph.junctions[at(junction)].incident) {
    const Cover& cover = runs_[at(incidence.run)].cover;
    for (const Beam& beam : cover.beams) {
      if (beam.hasHoleAt(incidence.index)) {
        layers[at(lattice::index(cover.axis))] |=
            1U << static_cast<unsigned>(beam.layer + guide::kMaxLayer);
      }
    }
  }
  if (onAxle(junction)) {
    countStackOnAxle(junction, &layers, state);
  }
  for (std::size_t axis = 0; axis < layers.size(); ++axis) {
    const StackFaults faults = stackFaults(layers[axis]);
    state->overfull += faults.overfull;
    if (faults.fillable == 0 || !problem_->spacers) {
      state->gaps += faults.gaps;
      continue;
    }
    int layer = -guide::kMaxLayer;
    unsigned rest = layers[axis];
    for (; (rest & 1U) == 0U; rest >>= 1U) {
      ++layer;
    }
    for (; rest != 0U; rest >>= 1U, ++layer) {
      if ((rest & 1U) == 0U) {
        state->spacers.push_back({lattice::axisFromIndex(static_cast<int>(axis)), layer});
      }
    }
  }
}

}  // namespace liftarm::layout
