#include "rivals/random_walk.h"

#include <utility>

namespace liftarm::rivals {

RandomWalk::RandomWalk(const layout::LayoutProblem& problem,
                       layout::ConnectionSolver& solver,
                       RivalOptions options)
    : RivalSearch(problem, solver, std::move(options)),
      moves_(static_cast<std::uint64_t>(
          this->options().effort *
          static_cast<double>(kMovesPerSize * static_cast<std::uint64_t>(problemSize(problem))))) {}

bool RandomWalk::step() {
  if (iterations() == 1) {
    paperOperator().initialise(&beams());
  } else {
    paperOperator().modify(&beams(), 0.0);
  }
  const Judgement judgement = judge().look(&beams());
  judge().keep(&beams());
  offer(beams(), judgement);
  return iterations() > moves_;
}

double RandomWalk::share() const {
  return static_cast<double>(iterations()) / static_cast<double>(moves_ + 1);
}

}  // namespace liftarm::rivals
