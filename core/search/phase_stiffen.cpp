#include "search/phase_stiffen.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "search/phase_axles.h"
#include "search/phase_first_layout.h"
#include "search/tuning.h"

namespace liftarm::search {

namespace {

constexpr const StiffeningTuning& kStiff = kTuning.stiffening;

RoundPlan stiffRound(const SearchState& state) {
  const AnnealingOptions& options = state.options();
  const double share = options.stiffening.share;
  const double perRuns = static_cast<double>(options.iterationsPerRun) *
                         static_cast<double>(state.graph().runs.size());
  return {static_cast<std::uint64_t>(share * static_cast<double>(options.minIterations)) +
              static_cast<std::uint64_t>(share * perRuns),
          kStiff.temperature};
}

RoundPlan plainRound(const SearchState& state) {
  return {roundLength(state.options(), 1.0, state.graph().runs.size()),
          state.options().startTemperature};
}

}  // namespace

Next Stiffening::endRound() {
  const auto runs = static_cast<double>(state().graph().runs.size());
  work_ += static_cast<double>(state().clock().roundLength()) * runs * runs;
  return state().isOverworked() ? goTo<AxleTrials>() : goOn();
}

const LayoutSnapshot& Stiffening::bestOfStart() const {
  return again_ ? *again_ : state().best();
}

//! The next round of this start, or of another start when this one stays loose.
Next Stiffening::goOn() {
  const StiffeningOptions& options = state().options().stiffening;
  const bool hopeless =
      allStiffRounds_ >= kStiff.hopefulRounds && state().best().freedoms > kStiff.fewFreedoms;
  if (hopeless || allStiffRounds_ >= options.rounds ||
      (allStiffRounds_ >= kStiff.leastRounds && work_ >= options.work)) {
    return goTo<AxleTrials>();
  }
  if (bestOfStart().faultless() && stiffRounds_ < options.roundsPerStart) {
    if (stiffRounds_ >= kStiff.symmetric && options.frees) {
      releaseLooseRuns();
    }
    return stiffen();
  }
  if (!options.otherStarts) {
    return goTo<AxleTrials>();
  }
  if (again_ && !stiffening_ && ++plainRounds_ < kStiff.plainRounds) {
    return plainRound(state());
  }
  return startAgain();
}

//! Rather stiff than symmetric in every beam: what moves need not be as the symmetries have it.
void Stiffening::releaseLooseRuns() {
  OrbitCovers& orbits = state().covering().orbits();
  const AnnealingOptions& options = state().options();
  if (!orbits.active() || options.freedoms(bestOfStart()) == 0) {
    return;
  }
  for (const int run : options.looseRuns()) {
    if (orbits.binds(run)) {
      orbits.release(run, bestOfStart().covers);
    }
  }
}

//! Says what the best layout of this start is worth while a freedom costs what it does now.
void Stiffening::rate(int freedoms) {
  const double energy = state().judge().plain(bestOfStart().tallies, freedoms);
  if (again_) {
    again_->freedoms = freedoms;
    again_->energy = energy;
    offerAgain();
  } else {
    state().rateBest(freedoms, energy);
  }
}

//! A further round from the best layout of this start, in which what is loose costs too.
Next Stiffening::stiffen() {
  const StiffeningOptions& options = state().options().stiffening;
  state().restore(bestOfStart());
  int freedoms = bestOfStart().freedoms;
  if (!stiffening_) {
    stiffening_ = true;
    // What cannot be built is to give way to anything that can and is as stiff.
    freedoms =
        state().options().freedoms(bestOfStart()) + (state().isBuildable(bestOfStart()) ? 0 : 1);
  }
  const std::size_t step = std::min<std::size_t>(stiffRounds_, kStiff.freedomCosts.size() - 1);
  state().setFreedomCost(options.weight * kStiff.freedomCosts[step]);
  ++stiffRounds_;
  ++allStiffRounds_;
  rate(freedoms);
  state().setFreedoms(freedoms);
  state().accept();
  loose_.clear();
  if (state().best().freedoms == 0 && (!options.polish || allStiffRounds_ > 1)) {
    return goTo<AxleTrials>();
  }
  return stiffRound(state());
}

//! Other hole axes, first without a thought for what is loose.
Next Stiffening::startAgain() {
  stiffening_ = false;
  loose_.clear();
  again_ = LayoutSnapshot{};
  state().setFreedoms(0);
  state().setFreedomCost(0.0);
  stiffRounds_ = 0;
  plainRounds_ = 0;
  layAgain(state());
  keep();
  return plainRound(state());
}

//! The best of this start is the best of all where it is less loose for what it costs.
void Stiffening::offerAgain() {
  const auto rank = [&](const LayoutSnapshot& layout) {
    const double freedoms = kStiff.freedomCosts.back() * layout.freedoms;
    return std::tuple(layout.tallies.violations(),
                      layout.missing,
                      state().judge().soft(layout.tallies) + freedoms);
  };
  if (rank(*again_) < rank(state().best())) {
    state().setBest(*again_);
  }
}

bool Stiffening::passes(double limit) {
  if (!stiffening_) {
    return Phase::passes(limit);
  }
  const int before = state().freedoms();
  state().setFreedoms(0);
  const bool settled = Phase::passes(limit);
  state().setFreedoms(before);
  if (!settled) {
    return false;
  }
  if (state().layout().tallies().violations() == 0) {
    state().setFreedoms(state().options().freedoms(state().snapshot()));
  }
  if (state().measure() <= limit) {
    return true;
  }
  state().setFreedoms(before);
  return false;
}

void Stiffening::afterMove() {
  const AnnealingOptions& options = state().options();
  if (stiffening_ && options.looseRuns && state().layout().tallies().violations() == 0) {
    loose_ = options.looseRuns();
  }
  keep();
}

//! Keeps the layout as the best one of this start where it is. The rounds that ask for freedoms
//! keep none that cannot be built.
void Stiffening::keep() {
  if (!state().beats(bestOfStart())) {
    return;
  }
  LayoutSnapshot candidate = state().ratedSnapshot();
  if (stiffening_ && !state().isBuildable(candidate)) {
    return;
  }
  if (!again_) {
    state().setBest(std::move(candidate));
    return;
  }
  again_ = std::move(candidate);
  if (stiffening_) {
    offerAgain();
  }
}

}  // namespace liftarm::search
