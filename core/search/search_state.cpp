#include "search/search_state.h"

#include <tuple>
#include <utility>

#include "search/tuning.h"

namespace liftarm::search {

namespace {

double weightAfter(double weight, bool violated) {
  return violated ? weight + kTuning.rounds.weightStep
                  : 1.0 + (weight - 1.0) * kTuning.rounds.weightDecay;
}

}  // namespace

SearchState::SearchState(const layout::LayoutProblem& problem,
                         layout::ConnectionSolver& solver,
                         AnnealingOptions options)
    : problem_(&problem),
      solver_(&solver),
      options_(std::move(options)),
      rng_(options_.seed),
      clock_(options_.endTemperature),
      layout_(problem, solver),
      covering_(problem, options_, solver.table()),
      frames_(problem, options_),
      judge_(problem, options_.weights) {}

void SearchState::forgetGrudges() {
  layout_.setWeights(std::vector<double>(graph().junctions.size(), 1.0),
                     std::vector<double>(graph().runs.size(), 1.0));
}

void SearchState::raiseGrudges() {
  std::vector<double> junctionWeights = layout_.junctionWeights();
  std::vector<double> runWeights = layout_.runWeights();
  for (std::size_t j = 0; j < junctionWeights.size(); ++j) {
    const layout::JunctionState& junction = layout_.junction(static_cast<int>(j));
    junctionWeights[j] = weightAfter(junctionWeights[j], junction.violations() > 0);
  }
  for (std::size_t r = 0; r < runWeights.size(); ++r) {
    const layout::RunState& run = layout_.run(static_cast<int>(r));
    runWeights[r] = weightAfter(runWeights[r], run.collisions + run.forbidden > 0);
  }
  layout_.setWeights(std::move(junctionWeights), std::move(runWeights));
  accept();
}

LayoutSnapshot SearchState::snapshot() const {
  LayoutSnapshot snapshot;
  snapshot.tallies = layout_.tallies();
  for (std::size_t r = 0; r < graph().runs.size(); ++r) {
    snapshot.covers.push_back(coverOf(static_cast<int>(r)));
  }
  for (std::size_t j = 0; j < graph().junctions.size(); ++j) {
    snapshot.junctions.push_back(layout_.junction(static_cast<int>(j)));
  }
  return snapshot;
}

double SearchState::measure() {
  missing_ = covering_.missing(layout_);
  return judge_.of(layout_, missing_, freedoms_);
}

bool SearchState::beats(const LayoutSnapshot& other) const {
  const double plain = judge_.plain(layout_.tallies(), freedoms_);
  const auto rank =
      std::tuple(layout_.tallies().violations(), missing_, plain + kTuning.energy.same);
  return other.covers.empty() ||
         rank < std::tuple(other.tallies.violations(), other.missing, other.energy);
}

LayoutSnapshot SearchState::ratedSnapshot() const {
  LayoutSnapshot rated = snapshot();
  rated.energy = judge_.plain(rated.tallies, freedoms_);
  rated.missing = missing_;
  rated.freedoms = freedoms_;
  return rated;
}

void SearchState::setBest(LayoutSnapshot best) {
  best_ = std::move(best);
  ++improvements_;
}

void SearchState::rateBest(int freedoms, double energy) {
  best_.freedoms = freedoms;
  best_.energy = energy;
}

void SearchState::keepBest() {
  if (beats(best_)) {
    setBest(ratedSnapshot());
  }
}

bool SearchState::isBuildable(const LayoutSnapshot& layout) const {
  return !options_.buildable || options_.buildable(layout);
}

bool SearchState::withdrawFrames() {
  if (!hasFrame(best_) || isBuildable(best_)) {
    return false;
  }
  frames_.withdraw(&layout_);
  return true;
}

void SearchState::startOver() {
  grown_ = false;
  best_ = {};
  rng_ = base::Rng(options_.seed);
  covering_.bindAgain();
  forgetGrudges();
  clock_.startOver();
}

double SearchState::work() const {
  return kTuning.energy.beamWork * static_cast<double>(covering_.work()) +
         kTuning.energy.mechanismWork * static_cast<double>(solver_->work());
}

bool SearchState::isOverworked() const {
  return work() > (hasWhole() ? options_.mostWork : options_.mostWorkUntilWhole);
}

}  // namespace liftarm::search
