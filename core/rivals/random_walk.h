#pragma once

#include <cstdint>

#include "rivals/rival_search.h"

namespace liftarm::rivals {

//! \brief "(i) a random method, which starts with a random layout and applies the layout
//! modification operator to iteratively refine the layout for 50000n times" (paper, section 6).
//! \details Read: a walk that keeps every modification and remembers the best layout that it
//! passed; one that kept only what is better would be annealing without heat, and would find grids
//! of 2 and 3 without gaps, at which the paper says that it fails.
class RandomWalk final : public RivalSearch {
 public:
  static constexpr std::uint64_t kMovesPerSize = 50000;

  RandomWalk(const layout::LayoutProblem& problem,
             layout::ConnectionSolver& solver,
             RivalOptions options);

 protected:
  bool step() override;
  [[nodiscard]] double share() const override;

 private:
  std::uint64_t moves_;
};

}  // namespace liftarm::rivals
