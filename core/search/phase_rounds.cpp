#include "search/phase_rounds.h"

#include "search/phase_axles.h"
#include "search/phase_first_layout.h"
#include "search/phase_stiffen.h"
#include "search/tuning.h"

namespace liftarm::search {

namespace {

RoundPlan roundOf(const SearchState& state, double share) {
  return {roundLength(state.options(), share, state.graph().runs.size()),
          state.options().startTemperature};
}

}  // namespace

Next Rounds::begin() {
  return roundOf(state(), kTuning.rounds.firstShare);
}

Next Rounds::endRound() {
  ++round_;
  const AnnealingOptions& options = state().options();
  const bool whole = state().hasWhole();
  if (whole && state().withdrawFrames()) {
    return StartOver{};
  }
  if (whole && options.freedoms && !state().isOverworked()) {
    return goTo<Stiffening>();
  }
  if (whole || round_ > options.maxRounds) {
    return goTo<AxleTrials>();
  }
  if (round_ % kTuning.rounds.perStart == 0) {
    loosenSymmetry();
    layAgain(state());
  }
  return roundOf(state(), 1.0);
}

//! Where a symmetric layout could not be made whole, the runs there are freed; at last, all are.
void Rounds::loosenSymmetry() {
  OrbitCovers& orbits = state().covering().orbits();
  if (!orbits.active() || round_ < kTuning.rounds.symmetric) {
    return;
  }
  if (round_ >= kTuning.rounds.lastSymmetric) {
    orbits.releaseAll();
    return;
  }
  const std::vector<layout::JunctionState>& junctions = state().best().junctions;
  for (std::size_t j = 0; j < junctions.size(); ++j) {
    if (orbits.active() && junctions[j].violations() > 0) {
      orbits.releaseAt(static_cast<int>(j));
    }
  }
}

}  // namespace liftarm::search
