#include "search/phase_axles.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/index.h"
#include "layout/axle_collisions.h"
#include "search/phase_holds.h"
#include "search/tuning.h"

namespace liftarm::search {

namespace {

using base::at;

int partsOf(const layout::Tallies& tallies) {
  return tallies.beams + tallies.connectors;
}

}  // namespace

Next AxleTrials::begin() {
  const LayoutSnapshot& best = state().best();
  const bool whole = best.tallies.violations() == 0 && !best.covers.empty();
  if (!whole || state().covering().axles().runs().empty()) {
    return goTo<FurtherHolds>();
  }
  state().setFreedoms(0);
  state().setFreedomCost(0.0);
  state().forgetGrudges();
  state().restore(best);
  const CoverCosts& costs = state().covering().costs();
  if (state().options().freedoms) {
    freedomsBefore_ = state().options().freedoms(best);
  }
  trials_ = findAxleFamilies(
      state().layout(), freeRuns(), {costs.beam, costs.hole, costs.hinge, worthOfFreedoms()});
  const auto moves = static_cast<double>(state().clock().moves());
  movesLeft_ = static_cast<std::uint64_t>(kTuning.axles.mostShare * moves);
  checksLeft_ = kTuning.axles.mostChecks;
  return nextTrial();
}

//! The runs that an axle may be tried on without a thought for symmetries: those that none binds,
//! nor anything that they meet; and those that are their own images and whose neighbours need not
//! turn for it, such as the ridge of a roof.
std::vector<int> AxleTrials::freeRuns() const {
  const OrbitCovers& orbits = state().covering().orbits();
  const auto isAlone = [&](int run) {
    const std::vector<guide::RunImage>& images = orbits.orbits().images(run);
    return std::all_of(images.begin(), images.end(), [run](const guide::RunImage& image) {
      return image.run == run;
    });
  };
  const std::vector<int>& all = state().covering().axles().runs();
  std::vector<int> runs;
  std::copy_if(all.begin(), all.end(), std::back_inserter(runs), [&](int run) {
    const lattice::Axis axis = layout::alongAxisOf(state().graph().runs[at(run)]).axis;
    const std::vector<int> met = runsMet(state().graph(), run);
    return (!orbits.binds(run) || isAlone(run)) &&
           std::none_of(met.begin(), met.end(), [&](int other) {
             return orbits.binds(other) && state().coverOf(other).axis != axis;
           });
  });
  return runs;
}

Next AxleTrials::nextTrial() {
  while (next_ < trials_.size() && checksLeft_ > 0) {
    if (beginTrial(trials_[next_++])) {
      return RoundPlan{moves_, kTuning.axles.temperature};
    }
    state().layout().revert();
  }
  return goTo<FurtherHolds>();
}

//! Lays axles on all runs of a family, and what goes with them. \return False when that cannot be.
bool AxleTrials::beginTrial(const AxleFamily& family) {
  const AxleTuning& tuning = kTuning.axles;
  state().restore(state().best());
  const lattice::Axis axis =
      layout::alongAxisOf(state().graph().runs[at(family.runs.front())]).axis;
  if (!clear(family, axis)) {
    return false;
  }
  moves_ = std::min(tuning.mostMoves, tuning.fewMoves + tuning.movesPerRun * touched_.size());
  if (moves_ > movesLeft_ || !layAll(family, axis)) {
    return false;
  }
  state().layout().settle();
  state().layout().keep();
  movesLeft_ -= moves_;
  focus_.assign(touched_.begin(), touched_.end());
  bestTrial_ = {};
  state().accept();
  keep();
  return true;
}

//! Clears the runs of a family, and what they meet where its hole axis must turn. \return False
//! where a bent beam, a frame or what the sketch keeps forbids it, or an axle of an earlier trial
//! lies there.
bool AxleTrials::clear(const AxleFamily& family, lattice::Axis axis) {
  layout::Layout& layout = state().layout();
  touched_ = {family.runs.begin(), family.runs.end()};
  turned_.clear();
  for (const int run : family.runs) {
    if (state().covering().orbits().binds(run)) {
      state().covering().orbits().release(run);
    }
    if (state().coverOf(run).axle.used() || state().problem().keepOf(run) != nullptr) {
      return false;
    }
    layout.setCover(run, {state().coverOf(run).axis, {}});
    for (const int met : runsMet(state().graph(), run)) {
      touched_.insert(met);
      if (state().coverOf(met).axis == axis) {
        continue;
      }
      if (layout::hasArms(state().coverOf(met)) || state().problem().keepOf(met) != nullptr) {
        return false;
      }
      turned_.push_back(met);
      layout.setCover(met, {axis, {}});
    }
  }
  return true;
}

//! Covers what was turned, then lays the axles. \return False where one of these cannot be.
bool AxleTrials::layAll(const AxleFamily& family, lattice::Axis axis) {
  for (const int run : turned_) {
    const std::vector<int> met = runsMet(state().graph(), run);
    touched_.insert(met.begin(), met.end());
    if (!state().cover({run, axis})) {
      return false;
    }
  }
  return std::all_of(family.runs.begin(), family.runs.end(), [&](int run) {
    return state().covering().axles().lay(&state().layout(), run);
  });
}

//! Keeps what an axle more makes of the best layout so far, if it is worth it.
void AxleTrials::keep() {
  const layout::Tallies& now = state().layout().tallies();
  const LayoutSnapshot& best = state().best();
  const layout::Tallies& before = best.tallies;
  const double plain = state().judge().soft(now);
  const double least = bestTrial_.covers.empty() ? state().judge().soft(before) -
                                                       kTuning.axles.leastSaving + worthOfFreedoms()
                                                 : bestTrial_.energy;
  if (now.violations() > 0 || state().missing() > best.missing || now.axles <= before.axles ||
      now.beams > before.beams || partsOf(now) > partsOf(before) || plain >= least) {
    return;
  }
  bestTrial_ = state().snapshot();
  bestTrial_.energy = plain;
  bestTrial_.missing = state().missing();
}

//! What an axle may save besides where something moves: it is no beam that could turn.
double AxleTrials::worthOfFreedoms() const {
  return kTuning.holds.worth * freedomsBefore_;
}

//! Whether the model of a trial is as stiff as the best one and can be built.
bool AxleTrials::isSound(LayoutSnapshot* trial) {
  const AnnealingOptions& options = state().options();
  const LayoutSnapshot& best = state().best();
  if (options.freedoms) {
    trial->freedoms = options.freedoms(*trial);
    const double worth = kTuning.holds.worth * (freedomsBefore_ - trial->freedoms);
    if (trial->freedoms > freedomsBefore_ ||
        trial->energy > state().judge().soft(best.tallies) - kTuning.axles.leastSaving + worth) {
      return false;
    }
  }
  if (options.held) {
    const int before = heldBefore_ ? *heldBefore_ : options.held(best);
    heldBefore_ = before;
    if (options.held(*trial) > before) {
      return false;
    }
  }
  --checksLeft_;
  return state().isBuildable(*trial);
}

Next AxleTrials::endRound() {
  if (!bestTrial_.covers.empty() && isSound(&bestTrial_)) {
    const double saved = state().judge().soft(state().best().tallies) - bestTrial_.energy;
    bestTrial_.energy = state().best().energy - saved;
    freedomsBefore_ = bestTrial_.freedoms;
    state().setBest(std::move(bestTrial_));
    // From here on this is what others are compared with.
    heldBefore_.reset();
  }
  return nextTrial();
}

}  // namespace liftarm::search
