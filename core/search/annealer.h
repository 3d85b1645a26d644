#pragma once

#include <cstdint>
#include <memory>

#include "search/annealing_options.h"
#include "search/layout_search.h"
#include "search/phase.h"
#include "search/run_picker.h"
#include "search/search_state.h"

namespace liftarm::search {

//! \brief Stage two: simulated annealing (paper 5.3) whose move covers one run, or two that meet,
//! anew and exactly (RunCoverer), and joins what it touched anew (ConnectionSolver). \details Where
//! violations stay, their places gain weight until the search leaves them (as breakout local search
//! does); the best layout is kept by (violations, energy). Stepped and deterministic.
//!
//! The search is a walk through phases (search/phase.h), each of which says what comes next:
//! FromEarlier or FirstLayout, Rounds, Stiffening where somebody minds what is loose, AxleTrials,
//! FurtherHolds where something moves all the same.
//! Moves are rows of a table (search/moves.h). Here they are made, judged, and kept or reverted.
class Annealer final : public LayoutSearch {
 public:
  //! \pre problem and solver outlive the annealer.
  Annealer(const layout::LayoutProblem& problem,
           layout::ConnectionSolver& solver,
           AnnealingOptions options);

  //! \brief At most `iterations` moves. \return True when the search has ended.
  bool advance(std::uint32_t iterations) override;

  [[nodiscard]] bool done() const override { return done_; }

  [[nodiscard]] const LayoutSnapshot& best() const override { return state_.best(); }

  [[nodiscard]] std::uint32_t improvements() const override { return state_.improvements(); }

  [[nodiscard]] std::uint64_t iterations() const override { return state_.clock().allMoves(); }

  [[nodiscard]] double temperature() const override { return state_.clock().temperature(); }

  [[nodiscard]] double work() const override { return state_.work(); }

  //! \brief Never less than it was: a search that starts over stays where it is for a while.
  [[nodiscard]] double fraction() const override { return done_ ? 1.0 : fraction_; }

  //! \brief "stageOne" until the first layout is there, then "stageTwo", then "done".
  [[nodiscard]] const char* phase() const override;

  [[nodiscard]] bool grown() const override { return state_.grown(); }

  [[nodiscard]] const layout::Layout& current() const { return state_.layout(); }

 private:
  void go(Next next);
  void step();
  void move();

  SearchState state_;
  RunPicker picker_;
  std::unique_ptr<Phase> phase_;  // none before the first step
  bool done_ = false;
  double fraction_ = 0.0;
};

}  // namespace liftarm::search
