#pragma once

#include <memory>
#include <span>
#include <variant>

#include "search/move_clock.h"
#include "search/search_state.h"

namespace liftarm::search {

class Phase;

using MakePhase = std::unique_ptr<Phase> (*)(SearchState& state);

//! \brief The search goes on in another phase.
struct NextPhase {
  MakePhase make = nullptr;
};

//! \brief The search begins anew with its first layout; what was withdrawn stays so.
struct StartOver {};

struct EndOfSearch {};

//! \brief What a phase says comes next: a round of moves of its own, or something else.
using Next = std::variant<RoundPlan, NextPhase, StartOver, EndOfSearch>;

//! \brief How a phase wants its moves.
struct MoveHabits {
  std::span<const int> focus = {};  //!< runs at which they begin, most of the time; empty: any
  std::span<const int> loose = {};  //!< runs that move and should not: there, before all else
  bool stiffening = false;          //!< rows of the table of moves have weights of their own then
};

//! \brief A phase of the search. It owns what it keeps track of, reads nothing of another, and says
//! what comes next when it begins and after each of its rounds (search/annealer.h lists them).
class Phase {
 public:
  //! \pre state outlives the phase.
  explicit Phase(SearchState& state) : state_(&state) {}

  Phase(const Phase&) = delete;
  Phase& operator=(const Phase&) = delete;
  virtual ~Phase() = default;

  //! \brief Called once, before anything else.
  virtual Next begin() = 0;

  //! \brief Called when as many moves were made as the phase asked for.
  virtual Next endRound() = 0;

  [[nodiscard]] virtual MoveHabits habits() const { return {}; }

  //! \brief Settles what a move changed. \return Whether the energy is within the limit then; if
  //! not, the layout may be half settled and is to be reverted.
  virtual bool passes(double limit);

  //! \brief A move was made and stays.
  virtual void afterMove() { state_->keepBest(); }

 protected:
  [[nodiscard]] SearchState& state() { return *state_; }

  [[nodiscard]] const SearchState& state() const { return *state_; }

 private:
  SearchState* state_;
};

//! \brief Goes on with a phase of this class.
template <typename Kind>
Next goTo() {
  return NextPhase{
      [](SearchState& state) -> std::unique_ptr<Phase> { return std::make_unique<Kind>(state); }};
}

//! \brief How long a round is: a share of what the options say for `runs` runs.
std::uint64_t roundLength(const AnnealingOptions& options, double share, std::size_t runs);

}  // namespace liftarm::search
