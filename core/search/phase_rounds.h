#pragma once

#include <cstdint>

#include "search/phase.h"

namespace liftarm::search {

//! \brief Rounds of annealing until a layout is whole: every third starts from other hole axes, and
//! symmetries that stand in the way are given up. Then what is loose is made stiff, where somebody
//! minds, and axles are tried.
class Rounds final : public Phase {
 public:
  using Phase::Phase;

  Next begin() override;
  Next endRound() override;

 private:
  void loosenSymmetry();

  std::uint32_t round_ = 0;  // that are over
};

}  // namespace liftarm::search
