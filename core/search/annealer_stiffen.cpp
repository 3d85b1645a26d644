#include <algorithm>
#include <array>
#include <tuple>

#include "search/annealer.h"

namespace liftarm::search {

namespace {

// What a freedom costs in the rounds that stiffen one start: half a beam at first, more than any
// beam at last.
constexpr std::array<double, 4> kFreedomCosts{5, 8, 12, 20};
constexpr std::uint32_t kLeastRounds = 3;      // whatever their work
constexpr std::uint32_t kSymmetricRounds = 3;  // of one start, before all runs are freed
// What has more freedoms left than these after so many rounds is not made to be stiff.
constexpr std::uint32_t kHopefulRounds = 9;
constexpr int kFewFreedoms = 6;
constexpr std::uint32_t kPlainRounds = 2;  // for another start to become whole
constexpr double kStiffTemperature = 3.0;

bool isWhole(const LayoutSnapshot& layout) {
  return layout.tallies.violations() + layout.missing == 0;
}

}  // namespace

//! After a round: the next one of this start, or of another start when this one stays loose.
void Annealer::goOnStiffening() {
  const auto runs = static_cast<double>(problem_->graph.runs.size());
  stiffWork_ += stiffening_ || again_ ? static_cast<double>(roundLength_) * runs * runs : 0.0;
  const bool hopeless = allStiffRounds_ >= kHopefulRounds && best_.freedoms > kFewFreedoms;
  if (hopeless || allStiffRounds_ >= options_.stiffening.rounds ||
      (allStiffRounds_ >= kLeastRounds && stiffWork_ >= options_.stiffening.work)) {
    finish();
    return;
  }
  if (isWhole(again_ ? bestAgain_ : best_) && stiffRounds_ < options_.stiffening.roundsPerStart) {
    if (stiffRounds_ >= kSymmetricRounds && options_.stiffening.frees) {
      releaseLooseRuns();
    }
    beginStiffening();
    if (best_.freedoms == 0 && (!options_.stiffening.polish || allStiffRounds_ > 1)) {
      finish();
    }
  } else if (!options_.stiffening.otherStarts) {
    finish();
  } else if (again_ && !stiffening_ && ++plainRounds_ < kPlainRounds) {
    beginRound();
  } else {
    startAgain();
  }
}

//! Rather stiff than symmetric in every beam: what moves need not be as the symmetries have it.
void Annealer::releaseLooseRuns() {
  const LayoutSnapshot& best = again_ ? bestAgain_ : best_;
  if (!orbits_.active() || options_.freedoms(best) == 0) {
    return;
  }
  for (const int run : options_.looseRuns()) {
    if (orbits_.binds(run)) {
      orbits_.release(run);
    }
  }
}

//! A further round from the best layout of this start, in which what is loose costs too.
void Annealer::beginStiffening() {
  LayoutSnapshot& best = again_ ? bestAgain_ : best_;
  layout_.restore(best.covers, best.junctions);
  if (!stiffening_) {
    stiffening_ = true;
    plainTemperature_ = options_.startTemperature;
    options_.startTemperature = kStiffTemperature;
    // What cannot be built is to give way to anything that can and is as stiff.
    best.freedoms = options_.freedoms(best) + (isBuildable(best) ? 0 : 1);
  }
  freedomCost_ = options_.stiffening.weight *
                 kFreedomCosts[std::min<std::size_t>(stiffRounds_, kFreedomCosts.size() - 1)];
  ++stiffRounds_;
  ++allStiffRounds_;
  best.energy = plainEnergy(best.tallies, best.freedoms);
  if (again_) {
    offerAgain();
  }
  missing_ = best.missing;
  freedoms_ = best.freedoms;
  energy_ = energy();
  looseRuns_.clear();
  beginRound();
}

//! Other hole axes, first without a thought for what is loose.
void Annealer::startAgain() {
  if (stiffening_) {
    options_.startTemperature = plainTemperature_;
  }
  stiffening_ = false;
  again_ = true;
  ++startsAgain_;
  bestAgain_ = {};
  freedoms_ = 0;
  freedomCost_ = 0.0;
  stiffRounds_ = 0;
  plainRounds_ = 0;
  layAgain();
  beginRound();
  keepBest();
}

//! The best of this start is the best of all where it is less loose for what it costs.
void Annealer::offerAgain() {
  const auto rank = [&](const LayoutSnapshot& layout) {
    const double freedoms = kFreedomCosts.back() * layout.freedoms;
    measures_.tallies = layout.tallies;
    return std::tuple(layout.tallies.violations(),
                      layout.missing,
                      objective::value(measures_, softWeights_) + freedoms);
  };
  if (rank(bestAgain_) < rank(best_)) {
    best_ = bestAgain_;
    ++improvements_;
  }
}

//! Settles what was changed; whether the energy is within the limit then. How loose a layout is, is
//! asked last, and of whole layouts only.
bool Annealer::passes(double limit) {
  const int before = freedoms_;
  freedoms_ = 0;
  bool within = layout_.settle([&] { return energy() > limit; }) && energy() <= limit;
  freedoms_ = before;
  if (within && stiffening_) {
    freedoms_ = layout_.tallies().violations() == 0 ? options_.freedoms(snapshot()) : before;
    within = energy() <= limit;
    freedoms_ = within ? freedoms_ : before;
  }
  return within;
}

//! Where the current layout moves. \pre Its freedoms were asked last.
void Annealer::findLooseRuns() {
  if (stiffening_ && options_.looseRuns && layout_.tallies().violations() == 0) {
    looseRuns_ = options_.looseRuns();
  }
}

bool Annealer::isBuildable(const LayoutSnapshot& layout) const {
  return !options_.buildable || options_.buildable(layout);
}

}  // namespace liftarm::search
