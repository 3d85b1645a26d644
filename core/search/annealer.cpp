#include "search/annealer.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/det_math.h"
#include "search/moves.h"
#include "search/phase_earlier.h"
#include "search/phase_first_layout.h"
#include "search/tuning.h"

namespace liftarm::search {

namespace {

constexpr double kMostFraction = 0.99;  // until the search is done

}  // namespace

Annealer::Annealer(const layout::LayoutProblem& problem,
                   layout::ConnectionSolver& solver,
                   AnnealingOptions options)
    : state_(problem, solver, std::move(options)), picker_(problem.graph) {}

const char* Annealer::phase() const {
  if (!phase_) {
    return "stageOne";
  }
  return done_ ? "done" : "stageTwo";
}

//! Goes from phase to phase until one wants moves, or the search ends.
void Annealer::go(Next next) {
  while (!std::holds_alternative<RoundPlan>(next)) {
    if (std::holds_alternative<EndOfSearch>(next)) {
      done_ = true;
      return;
    }
    if (std::holds_alternative<StartOver>(next)) {
      state_.startOver();
      next = goTo<FirstLayout>();
    }
    phase_ = std::get<NextPhase>(next).make(state_);
    next = phase_->begin();
  }
  state_.clock().beginRound(std::get<RoundPlan>(next));
}

void Annealer::move() {
  if (!makeMove(state_, picker_, phase_->habits())) {
    state_.layout().revert();
    return;
  }
  state_.covering().axles().follow(&state_.layout());
  // The threshold is drawn first, so that a move that cannot pass it is not connected to its end.
  const double chance = state_.rng().unit();
  const double before = state_.energy();
  const double limit = chance <= 0.0 ? std::numeric_limits<double>::max()
                                     : before - state_.clock().temperature() * base::detLog(chance);
  if (!phase_->passes(limit)) {
    state_.layout().revert();
    return;
  }
  state_.layout().keep();
  state_.accept();
  if (state_.energy() < before - kTuning.energy.same) {
    state_.clock().noteProgress();
  }
  phase_->afterMove();
}

//! One move and what follows from it.
void Annealer::step() {
  MoveClock& clock = state_.clock();
  if (clock.isCheckDue()) {
    clock.cool();
    // Ends after this move: what is whole by then stays.
    done_ = state_.isOverworked() && !state_.hasWhole();
  }
  move();
  clock.countMove();
  if (state_.options().parts.growth && state_.layout().tallies().violations() > 0 &&
      clock.isStuck()) {
    state_.raiseGrudges();
    clock.noteProgress();
  }
  if (clock.roundIsOver()) {
    go(phase_->endRound());
  }
}

bool Annealer::advance(std::uint32_t iterations) {
  if (!phase_) {
    go(goTo<FromEarlier>());
  }
  for (std::uint32_t i = 0; i < iterations && !done_; ++i) {
    step();
  }
  fraction_ = std::max(fraction_, std::min(kMostFraction, state_.clock().fraction()));
  return done_;
}

}  // namespace liftarm::search
