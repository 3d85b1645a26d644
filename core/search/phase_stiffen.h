#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "search/phase.h"

namespace liftarm::search {

//! \brief Rounds that make a whole layout stiff: some from the best layout, in which each freedom
//! costs too, then some from that of another start, and so on. \pre AnnealingOptions::freedoms.
class Stiffening final : public Phase {
 public:
  using Phase::Phase;

  Next begin() override { return goOn(); }

  Next endRound() override;

  [[nodiscard]] MoveHabits habits() const override {
    return {.loose = loose_, .stiffening = stiffening_};
  }

  //! \brief How loose a layout is, is asked last, and of whole layouts only.
  bool passes(double limit) override;
  void afterMove() override;

 private:
  Next goOn();
  Next stiffen();
  Next startAgain();
  void keep();
  void offerAgain();
  void rate(int freedoms);
  void releaseLooseRuns();
  [[nodiscard]] const LayoutSnapshot& bestOfStart() const;

  bool stiffening_ = false;              // else another start is on its way to be whole
  std::optional<LayoutSnapshot> again_;  // best of another start than the first
  std::uint32_t stiffRounds_ = 0;        // of this start ...
  std::uint32_t plainRounds_ = 0;        // ... before which it had so many of the other kind
  std::uint32_t allStiffRounds_ = 0;
  double work_ = 0.0;       // of all starts, in moves times runs squared
  std::vector<int> loose_;  // runs that move in the layout
};

}  // namespace liftarm::search
