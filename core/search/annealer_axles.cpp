#include <algorithm>
#include <set>

#include "layout/axle_collisions.h"
#include "search/annealer.h"

// Axles that cover lines. Where a joint leaves no choice they lie from the first layout on. All
// others are tried at the end, on the best layout, line by line and whole families of lines at
// once: the runs that an axle goes through are turned and covered anew, what was touched is
// searched for a while, and it stays where it saves something, takes no more parts, and makes
// nothing loose.

namespace liftarm::search {

namespace {

constexpr double kTrialTemperature = 1.5;
constexpr double kLeastSaving = 0.5;  // in parts
// Moves of one trial, and of all trials as a share of those before them.
constexpr std::uint64_t kMovesPerRun = 30;
constexpr std::uint64_t kFewMoves = 60;
constexpr std::uint64_t kMostMoves = 500;
constexpr double kMostShare = 0.3;
constexpr int kMostChecks = 4;  // of all that makes a model buildable: they are dear

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

int partsOf(const layout::Tallies& tallies) {
  return tallies.beams + tallies.connectors;
}

}  // namespace

void Annealer::findAxleRuns() {
  const auto runs = static_cast<int>(problem_->graph.runs.size());
  mustHaveAxle_.assign(at(runs), 0);
  if (!options_.parts.axles || options_.axles.empty()) {
    return;
  }
  int longest = 0;
  for (const int axle : options_.axles) {
    longest = std::max(longest, layout::axleParts()[at(axle)].length);
  }
  for (int run = 0; run < runs; ++run) {
    if (!mayHaveAxle(problem_->graph, run, longest)) {
      continue;
    }
    axleRuns_.push_back(run);
    if (needsAxle(problem_->graph, run)) {
      mustHaveAxle_[at(run)] = 1;
    }
  }
}

//! Symmetries do not bind lines that must have an axle: each is laid for itself.
void Annealer::releaseAxleRuns() {
  for (const int run : axleRuns_) {
    if (mustHaveAxle_[at(run)] != 0 && orbits_.binds(run)) {
      orbits_.release(run);
    }
  }
}

//! The hole axes that axles which must be there ask of what they go through.
void Annealer::turnToAxles(guide::Orientation* orientation) const {
  for (const int run : axleRuns_) {
    if (mustHaveAxle_[at(run)] != 0) {
      for (const int met : runsMet(problem_->graph, run)) {
        (*orientation)[at(met)] = layout::alongAxisOf(problem_->graph.runs[at(run)]).axis;
      }
    }
  }
}

//! Lays the axle on a run that suits the beams which it meets. \return Whether that changed it.
bool Annealer::layAxleOn(int run) {
  const layout::Axle axle = layout::layAxle(layout_.axleSite(run), options_.axles);
  const layout::Cover& before = layout_.run(run).cover;
  const layout::Cover cover{before.axis, {}, axle};
  if (!axle.used() || cover == before) {
    return false;
  }
  layout_.setCover(run, cover);
  return true;
}

//! Axles follow the beams that they go through.
void Annealer::relayAxles() {
  if (layout_.tallies().axles == 0) {
    return;
  }
  for (const int run : axleRuns_) {
    if (layout_.run(run).cover.axle.used()) {
      layAxleOn(run);
    }
  }
}

//! The search is over but for axles that may cover lines of a whole layout.
void Annealer::finish() {
  const bool whole = best_.tallies.violations() == 0 && !best_.covers.empty();
  if (whole && !axleRuns_.empty()) {
    layout_.setWeights(std::vector<double>(problem_->graph.junctions.size(), 1.0),
                       std::vector<double>(problem_->graph.runs.size(), 1.0));
    layout_.restore(best_.covers, best_.junctions);
    std::vector<int> runs;
    std::copy_if(axleRuns_.begin(), axleRuns_.end(), std::back_inserter(runs), [&](int run) {
      const std::vector<int> met = runsMet(problem_->graph, run);
      return !orbits_.binds(run) &&
             std::none_of(met.begin(), met.end(), [&](int other) { return orbits_.binds(other); });
    });
    const CoverCosts& costs = coverer_.costs();
    trials_ = findAxleFamilies(layout_, runs, {costs.beam, costs.hole, costs.hinge});
    trialMovesLeft_ = static_cast<std::uint64_t>(kMostShare * static_cast<double>(iteration_));
    checksLeft_ = kMostChecks;
    stiffening_ = false;
    trying_ = true;
  }
  nextTrial();
}

void Annealer::nextTrial() {
  while (nextTrial_ < trials_.size() && checksLeft_ > 0) {
    if (beginTrial(trials_[nextTrial_++])) {
      return;
    }
    layout_.revert();
  }
  trying_ = false;
  done_ = true;
}

//! Lays axles on all runs of a family, and what goes with them. \return False when that cannot be.
bool Annealer::beginTrial(const AxleFamily& family) {
  layout_.restore(best_.covers, best_.junctions);
  const lattice::Axis axis =
      layout::alongAxisOf(problem_->graph.runs[at(family.runs.front())]).axis;
  std::set<int> touched(family.runs.begin(), family.runs.end());
  std::vector<int> turned;
  for (const int run : family.runs) {
    if (layout_.run(run).cover.axle.used()) {
      return false;  // it was part of a trial that went well
    }
    layout_.setCover(run, {layout_.run(run).cover.axis, {}});
    for (const int met : runsMet(problem_->graph, run)) {
      touched.insert(met);
      if (layout_.run(met).cover.axis == axis) {
        continue;
      }
      if (layout::hasArms(layout_.run(met).cover)) {
        return false;
      }
      turned.push_back(met);
      layout_.setCover(met, {axis, {}});
    }
  }
  const std::uint64_t moves = std::min(kMostMoves, kFewMoves + kMovesPerRun * touched.size());
  if (moves > trialMovesLeft_) {
    return false;
  }
  coverer_.setReach(guide::kMaxLayer);
  for (const int run : turned) {
    const std::vector<int> met = runsMet(problem_->graph, run);
    touched.insert(met.begin(), met.end());
    if (!coverRun(run, axis, 0.0, {})) {
      return false;
    }
  }
  for (const int run : family.runs) {
    if (!layAxleOn(run)) {
      return false;
    }
  }
  layout_.settle();
  layout_.keep();
  trialMovesLeft_ -= moves;
  focus_.assign(touched.begin(), touched.end());
  bestTrial_ = {};
  freedomCost_ = 0.0;
  energy_ = energy();
  roundBegin_ = iteration_;
  roundLength_ = moves;
  lastChange_ = iteration_;
  options_.startTemperature = kTrialTemperature;
  temperature_ = kTrialTemperature;
  keepBestTrial();
  return true;
}

//! What an axle more makes of the best layout so far, if it is worth it.
void Annealer::keepBestTrial() {
  const layout::Tallies& now = layout_.tallies();
  const layout::Tallies& before = best_.tallies;
  const double plain = plainEnergy(now, 0);
  const double least =
      bestTrial_.covers.empty() ? plainEnergy(before, 0) - kLeastSaving : bestTrial_.energy;
  if (now.violations() > 0 || missing_ > best_.missing || now.axles <= before.axles ||
      now.beams > before.beams || partsOf(now) > partsOf(before) || plain >= least) {
    return;
  }
  bestTrial_ = snapshot();
  bestTrial_.energy = plain;
  bestTrial_.missing = missing_;
}

//! Whether the model of a trial is as stiff as the best one and can be built.
bool Annealer::isSound(LayoutSnapshot* trial) {
  if (options_.freedoms) {
    trial->freedoms = options_.freedoms(*trial);
    if (trial->freedoms > best_.freedoms) {
      return false;
    }
  }
  if (options_.held) {
    const int before = heldBefore_ ? *heldBefore_ : options_.held(best_);
    heldBefore_ = before;
    if (options_.held(*trial) > before) {
      return false;
    }
  }
  --checksLeft_;
  return isBuildable(*trial);
}

void Annealer::finishTrial() {
  if (!bestTrial_.covers.empty() && isSound(&bestTrial_)) {
    const double saved = plainEnergy(best_.tallies, 0) - bestTrial_.energy;
    bestTrial_.energy = best_.energy - saved;
    best_ = std::move(bestTrial_);
    ++improvements_;
    // From here on this is what others are compared with.
    heldBefore_.reset();
  }
  nextTrial();
}

}  // namespace liftarm::search
