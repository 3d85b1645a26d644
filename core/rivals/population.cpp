#include "rivals/population.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/det_math.h"

namespace liftarm::rivals {

namespace {

constexpr double kSame = 1e-9;

}  // namespace

Population::Population(const layout::LayoutProblem& problem,
                       layout::ConnectionSolver& solver,
                       RivalOptions options)
    : problem_(&problem),
      solver_(&solver),
      options_(std::move(options.paper)),
      rng_(options_.seed),
      temperature_(options_.startTemperature) {
  options_.coolingRate = search::paperCoolingRate(problem, options_);
  if (options.effort != 1.0) {
    options_.coolingRate = base::detExp(base::detLog(options_.coolingRate) / options.effort);
  }
}

double Population::fraction() const {
  const double all = base::detLog(options_.endTemperature / options_.startTemperature);
  const double now = base::detLog(temperature_ / options_.startTemperature);
  return done_ ? 1.0 : std::min(0.99, now / all);
}

const char* Population::phase() const {
  if (states_.empty()) {
    return "stageOne";
  }
  return done_ ? "done" : "stageTwo";
}

void Population::begin() {
  const search::PaperStateOptions options{options_.corners, options_.lengths, options_.weights};
  states_.reserve(kKept);
  for (int k = 0; k < kKept; ++k) {
    states_.emplace_back(*problem_, *solver_, options, &rng_);
  }
  keepBest();
}

void Population::useFullObjective() {
  for (search::PaperState& state : states_) {
    state.useFullObjective();
  }
  best_.covers.clear();  // values of the two objectives cannot be compared
  keepBest();
}

std::vector<Population::Found> Population::find() {
  std::vector<Found> found;
  for (std::size_t s = 0; s < states_.size(); ++s) {
    search::PaperState& state = states_[s];
    bool stays = false;
    for (int i = 0; i < kFound / kKept; ++i) {
      state.propose();
      const double change = state.proposedEnergy() - state.energy();
      if (base::detExp(-change / temperature_) > rng_.unit()) {
        found.push_back({s, state.changes(), state.proposedEnergy()});
      } else {
        stays = true;
      }
      state.reject();
    }
    if (stays) {
      found.push_back({s, {}, state.energy()});
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
    return a.energy < b.energy;
  });
  return found;
}

void Population::goOnWith(const std::vector<Found>& chosen) {
  std::vector<search::PaperState> next;
  next.reserve(chosen.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const Found& one = chosen[i];
    const bool neededLater = std::any_of(
        chosen.begin() + static_cast<std::ptrdiff_t>(i) + 1, chosen.end(), [&](const Found& other) {
          return other.parent == one.parent;
        });
    if (neededLater) {
      next.push_back(states_[one.parent]);
    } else {
      next.push_back(std::move(states_[one.parent]));
    }
    if (!one.changes.empty()) {
      next.back().propose(one.changes);
      next.back().accept();
    }
  }
  states_ = std::move(next);
}

void Population::iterate() {
  std::vector<Found> found = find();
  found.resize(std::min(found.size(), static_cast<std::size_t>(kKept)));
  goOnWith(found);
  keepBest();
  ++iteration_;
  temperature_ *= options_.coolingRate;
  done_ = temperature_ <= options_.endTemperature;
}

void Population::keepBest() {
  for (const search::PaperState& state : states_) {
    const int violations = state.violations();
    const int bestViolations = state.full() ? best_.tallies.violations() : 0;
    if (best_.covers.empty() || violations < bestViolations ||
        (violations == bestViolations && state.energy() < best_.energy - kSame)) {
      ++improvements_;
      best_ = state.snapshot();
    }
  }
}

bool Population::advance(std::uint32_t iterations) {
  if (states_.empty()) {
    begin();
  }
  for (std::uint32_t i = 0; i < iterations && !done_; ++i) {
    if (!states_.front().full() && temperature_ < options_.middleTemperature) {
      useFullObjective();
    }
    iterate();
  }
  return done_;
}

}  // namespace liftarm::rivals
