#pragma once

#include <vector>

#include "search/earlier_layout.h"
#include "search/phase.h"

namespace liftarm::search {

//! \brief Goes on from the layout of an earlier sketch: what was not touched stays as it lies, what
//! is new is covered, and one round of moves begins at what was touched. Where that does not end
//! whole, or takes many more beams, the search starts over and is as without it.
class FromEarlier final : public Phase {
 public:
  using Phase::Phase;

  //! \brief The first layout comes next where there is nothing to go on from.
  Next begin() override;
  Next endRound() override;

  [[nodiscard]] MoveHabits habits() const override { return {.focus = touched_}; }

 private:
  void lay(const KeptRuns& kept);
  void layBestAxis(int run);
  [[nodiscard]] bool keepsUp() const;

  std::vector<int> touched_;  // runs that moves begin at; where there are none, any
  int mostBeams_ = 0;         // that what came of the earlier layout may have
};

}  // namespace liftarm::search
