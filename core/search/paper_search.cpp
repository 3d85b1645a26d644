#include "search/paper_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/det_math.h"

namespace liftarm::search {

namespace {

constexpr double kSimpleRate = 0.999;
constexpr double kComplexRate = 0.99997;
constexpr double kSame = 1e-9;

//! Moves until the exponential schedule has come down to a temperature.
std::uint64_t movesUntil(const PaperOptions& options, double temperature) {
  const double moves =
      base::detLog(temperature / options.startTemperature) / base::detLog(options.coolingRate);
  return static_cast<std::uint64_t>(std::max(1.0, moves + 1.0));
}

}  // namespace

double paperCoolingRate(const layout::LayoutProblem& problem, const PaperOptions& options) {
  if (options.coolingRate != 0.0) {
    return options.coolingRate;
  }
  const bool complex = static_cast<int>(problem.graph.nodes.size()) >= kComplexNodes;
  return complex ? kComplexRate : kSimpleRate;
}

PaperSearch::PaperSearch(const layout::LayoutProblem& problem,
                         layout::ConnectionSolver& solver,
                         PaperOptions options)
    : problem_(&problem),
      solver_(&solver),
      options_(std::move(options)),
      rng_(options_.seed),
      temperature_(options_.startTemperature) {
  options_.coolingRate = paperCoolingRate(problem, options_);
  if (options_.cooling) {
    budget_ = movesUntil(options_, options_.endTemperature);
    middle_ = movesUntil(options_, options_.middleTemperature);
    cooling_ = options_.cooling({options_.startTemperature, options_.endTemperature, budget_});
  }
}

double PaperSearch::fraction() const {
  if (done_) {
    return 1.0;
  }
  if (cooling_) {
    return std::min(0.99, static_cast<double>(iteration_) / static_cast<double>(budget_));
  }
  const double all = base::detLog(options_.endTemperature / options_.startTemperature);
  const double now = base::detLog(temperature_ / options_.startTemperature);
  return std::min(0.99, now / all);
}

const char* PaperSearch::phase() const {
  if (!state_) {
    return "stageOne";
  }
  return done_ ? "done" : "stageTwo";
}

//! The full objective is used below T_mid; by other schedules at the latest from the move on at
//! which the exponential one would come to it.
bool PaperSearch::isStable() const {
  return temperature_ < options_.middleTemperature || (cooling_ && iteration_ >= middle_);
}

void PaperSearch::move() {
  state_->propose();
  const double before = state_->energy();
  const double after = state_->proposedEnergy();
  const bool kept = base::detExp((before - after) / temperature_) > rng_.unit();
  if (kept) {
    state_->accept();
    keepBest();
  } else {
    state_->reject();
  }
  ++iteration_;
  if (cooling_) {
    temperature_ = cooling_->next({temperature_, after, kept ? after - before : 0.0});
    done_ = iteration_ >= budget_;
  } else {
    temperature_ *= options_.coolingRate;
    done_ = temperature_ <= options_.endTemperature;
  }
}

void PaperSearch::keepBest() {
  const int violations = state_->violations();
  const int bestViolations = state_->full() ? best_.tallies.violations() : 0;
  const bool better = best_.covers.empty() || violations < bestViolations ||
                      (violations == bestViolations && state_->energy() < best_.energy - kSame);
  if (better) {
    ++improvements_;
    best_ = state_->snapshot();
  }
}

bool PaperSearch::advance(std::uint32_t iterations) {
  if (!state_) {
    state_.emplace(*problem_,
                   *solver_,
                   PaperStateOptions{options_.corners, options_.lengths, options_.weights},
                   &rng_);
    keepBest();
  }
  for (std::uint32_t i = 0; i < iterations && !done_; ++i) {
    if (!state_->full() && isStable()) {
      state_->useFullObjective();
      best_.covers.clear();  // values of the two objectives cannot be compared
      keepBest();
    }
    move();
  }
  return done_;
}

}  // namespace liftarm::search
