#pragma once

#include "rivals/rival_search.h"

namespace liftarm::rivals {

//! \brief "(ii) a greedy method, which progressively adds locally-optimum beams that cover the most
//! portions of the uncovered sketch" (paper, section 6). \details Read: each step lays the
//! placement that covers most uncovered edges, on the layer with the fewest taken nodes and gaps;
//! of placements that cover alike one at random, since nothing else is asked of them.
class Greedy final : public RivalSearch {
 public:
  using RivalSearch::RivalSearch;

 protected:
  bool step() override;
  [[nodiscard]] double share() const override;

 private:
  int edgesLeft_ = 1;
  int edgesAtFirst_ = 1;
};

}  // namespace liftarm::rivals
