#pragma once

#include <cstdint>

#include "base/det_math.h"
#include "search/tuning.h"

namespace liftarm::search {

//! \brief One round of annealing: so many moves, from one temperature down to another.
struct RoundPlan {
  std::uint64_t moves = 1;
  double startTemperature = 1.0;  //!< in units of the energy
};

//! \brief Counts moves and rounds, and says how warm it is. No clock of a machine.
class MoveClock {
 public:
  //! \param endTemperature Of every round.
  explicit MoveClock(double endTemperature) : endTemperature_(endTemperature) {}

  void beginRound(const RoundPlan& plan) {
    rounds_ += plan_.moves == 0 ? 0 : 1;
    plan_ = plan;
    roundBegin_ = moves_;
    temperature_ = plan.startTemperature;
    lastProgress_ = moves_;
  }

  void countMove() { ++moves_; }

  //! \brief Whether temperature and work are to be looked at before this move.
  [[nodiscard]] bool isCheckDue() const { return (moves_ & (kTuning.rounds.checkEvery - 1)) == 0; }

  //! \brief Cools exponentially with the share of the round that is over.
  void cool() {
    const double ratio = endTemperature_ / plan_.startTemperature;
    temperature_ = plan_.startTemperature * base::detExp(base::detLog(ratio) * share());
  }

  [[nodiscard]] bool roundIsOver() const { return moves_ - roundBegin_ >= plan_.moves; }

  void noteProgress() { lastProgress_ = moves_; }

  //! \brief Whether nothing got better for so many moves that places are to gain weight.
  [[nodiscard]] bool isStuck() const { return moves_ - lastProgress_ > kTuning.rounds.patience; }

  //! \brief The search begins anew: what was done until now only counts in allMoves().
  void startOver() {
    before_ += moves_;
    moves_ = 0;
    rounds_ = 0;
    plan_ = {0, 1.0};
  }

  [[nodiscard]] std::uint64_t moves() const { return moves_; }

  [[nodiscard]] std::uint64_t allMoves() const { return before_ + moves_; }

  [[nodiscard]] std::uint64_t roundLength() const { return plan_.moves; }

  [[nodiscard]] double temperature() const { return temperature_; }

  //! \brief From 0 to 1, if this round were the last.
  [[nodiscard]] double fraction() const {
    const auto rounds = static_cast<double>(rounds_);
    return (rounds + share()) / (rounds + 1.0);
  }

 private:
  //! How much of the round is over, from 0 to 1.
  [[nodiscard]] double share() const {
    return plan_.moves == 0
               ? 0.0
               : static_cast<double>(moves_ - roundBegin_) / static_cast<double>(plan_.moves);
  }

  double endTemperature_;
  RoundPlan plan_{0, 1.0};
  double temperature_ = 0.0;
  std::uint64_t moves_ = 0;   // since the search began or started over
  std::uint64_t before_ = 0;  // until then
  std::uint64_t roundBegin_ = 0;
  std::uint64_t rounds_ = 0;  // that are over
  std::uint64_t lastProgress_ = 0;
};

}  // namespace liftarm::search
