#include <algorithm>

#include "base/hash.h"
#include "base/index.h"
#include "layout/layout.h"

namespace liftarm::layout {

namespace {

using base::at;

constexpr int kFewFailures = 4;  // with more, other moves are worth more than giveWay()

}  // namespace

std::uint64_t Layout::signature(const RunView& view, const Cover& cover) const {
  std::uint64_t hash = static_cast<std::uint64_t>(lattice::index(cover.axis));
  for (const Beam& beam : cover.beams) {
    if (static_cast<double>(beam.solidLast()) < view.low ||
        static_cast<double>(beam.solidStart()) > view.high) {
      continue;
    }
    const int first = std::max(beam.start, static_cast<int>(view.low) - 2);
    const int last = std::min(beam.last(), static_cast<int>(view.high) + 2);
    hash = base::mixHash(hash, static_cast<std::uint64_t>(first + 4096));
    hash = base::mixHash(hash, static_cast<std::uint64_t>(last + 4096));
    hash = base::mixHash(hash, static_cast<std::uint64_t>(beam.layer + 64));
    hash = base::mixHash(hash, static_cast<std::uint64_t>(beam.mate + 1));
    hash = base::mixHash(hash, static_cast<std::uint64_t>(beam.tail + 1));
    hash = beam.site < 0 ? hash : base::mixHash(hash, static_cast<std::uint64_t>(beam.site));
  }
  if (cover.axle.used()) {
    hash = base::mixHash(hash, static_cast<std::uint64_t>(cover.axle.part + 1));
    hash = base::mixHash(hash, static_cast<std::uint64_t>(cover.axle.start + 64));
    hash = base::mixHash(hash, 2U * cover.axle.bushes + (cover.axle.turned ? 1U : 0U));
  }
  return hash;
}

//! Junctions whose surroundings are not what they were at keep().
void Layout::findStale() {
  for (const auto& [run, before] : savedRuns_) {
    const Cover& now = runs_[at(run)].cover;
    if (before.cover == now) {
      continue;
    }
    for (const auto& [junction, viewIndex] : problem_->seenBy[at(run)]) {
      const RunView& view = problem_->views[at(junction)].runs[at(viewIndex)];
      if (stale_[at(junction)] == 0 && signature(view, before.cover) != signature(view, now)) {
        stale_[at(junction)] = 1;
        staleList_.push_back(junction);
      }
    }
  }
  if (tallies_.axles > 0) {
    findStaleOnAxles();
  }
}

//! A junction that leans on a neighbour's mechanism must be solved again with it.
void Layout::spreadStale() {
  for (std::size_t i = 0; i < staleList_.size(); ++i) {
    for (const int other : problem_->graph.junctions[at(staleList_[i])].nearJunctions) {
      if (stale_[at(other)] == 0 && junctions_[at(other)].leans) {
        stale_[at(other)] = 1;
        staleList_.push_back(other);
      }
    }
  }
}

//! Takes the connections of all stale junctions off; their stacks are counted already. Returns the
//! least that joining them will cost: a part each, unless a neighbour may do it.
double Layout::clearStale() {
  double open = 0.0;
  openCosts_.clear();
  for (const int junction : staleList_) {
    saveJunction(junction);
    JunctionState& state = junctions_[at(junction)];
    addJunction(state, junction, -1);
    const bool several = problem_->graph.junctions[at(junction)].incident.size() > 1;
    const bool joined = state.leans || hasFrameAt(junction) || onAxle(junction);
    openCosts_.push_back(several && !joined ? 1.0 : 0.0);
    open += openCosts_.back();
    state = {};
    countStack(junction, &state);
    addJunction(state, junction, 1);
  }
  return open;
}

//! Asks `hopeless` with what is open at its least, and failures forgiven that giveWay() may mend.
bool Layout::givesUp(double open, const std::function<bool()>& hopeless) {
  if (!hopeless) {
    return false;
  }
  double forgiven = 0.0;
  if (tallies_.failedConnections <= kFewFailures) {
    for (const int junction : staleList_) {
      forgiven += static_cast<double>(junctions_[at(junction)].connection.failed) *
                  junctionWeights_[at(junction)];
    }
  }
  tallies_.connectionCost += open;
  weighted_ -= forgiven;
  const bool answer = hopeless();
  tallies_.connectionCost -= open;
  weighted_ += forgiven;
  return answer;
}

bool Layout::settle(const std::function<bool()>& hopeless) {
  findStale();
  spreadStale();
  std::sort(staleList_.begin(), staleList_.end());
  double open = clearStale();
  if (givesUp(open, hopeless)) {
    return false;
  }
  for (std::size_t i = 0; i < staleList_.size(); ++i) {
    const int junction = staleList_[i];
    JunctionState& state = junctions_[at(junction)];
    addJunction(state, junction, -1);
    state = {};
    solveJunction(junction);
    addJunction(state, junction, 1);
    stale_[at(junction)] = 0;
    open -= openCosts_[i];
    if (state.connection.cost > openCosts_[i] && givesUp(open, hopeless)) {
      return false;
    }
  }
  if (tallies_.failedConnections <= kFewFailures) {
    for (const int junction : staleList_) {
      if (junctions_[at(junction)].connection.failed > 0) {
        giveWay(junction);
      }
    }
  }
  staleList_.clear();
  return true;
}

//! Where a junction failed, its neighbours' mechanisms may stand in its way: it chooses first, they
//! after it, and that stays when fewer connections fail then.
void Layout::giveWay(int junction) {
  std::vector<int> order{junction};
  for (const int other : problem_->graph.junctions[at(junction)].nearJunctions) {
    const Connection& connection = junctions_[at(other)].connection;
    if (!connection.mechanisms.empty()) {
      order.push_back(other);
    }
  }
  // Junctions that lean on one of these from outside would have to follow: leave those alone.
  for (const int j : order) {
    for (const int other : problem_->graph.junctions[at(j)].nearJunctions) {
      if (junctions_[at(other)].leans &&
          std::find(order.begin(), order.end(), other) == order.end()) {
        return;
      }
    }
  }
  int before = 0;
  std::vector<JunctionState> states;
  for (const int j : order) {
    saveJunction(j);
    states.push_back(junctions_[at(j)]);
    before += states.back().violations();
    junctions_[at(j)] = {};
    countStack(j, &junctions_[at(j)]);
  }
  int after = 0;
  for (const int j : order) {
    solveJunction(j);
    after += junctions_[at(j)].violations();
  }
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (after < before) {
      addJunction(states[i], order[i], -1);
      addJunction(junctions_[at(order[i])], order[i], 1);
    } else {
      junctions_[at(order[i])] = std::move(states[i]);
    }
  }
}

}  // namespace liftarm::layout
