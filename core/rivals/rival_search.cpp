#include "rivals/rival_search.h"

#include <algorithm>
#include <utility>

namespace liftarm::rivals {

RivalSearch::RivalSearch(const layout::LayoutProblem& problem,
                         layout::ConnectionSolver& solver,
                         RivalOptions options)
    : problem_(&problem),
      solver_(&solver),
      options_(std::move(options)),
      rng_(options_.paper.seed),
      operator_(problem, options_.paper.corners, &rng_),
      beams_(problem, search::paperStageOne(problem.graph, &rng_), options_.paper.lengths),
      judge_(problem, solver) {}

double RivalSearch::fraction() const {
  return done_ ? 1.0 : std::clamp(share(), 0.0, 0.99);
}

const char* RivalSearch::phase() const {
  if (done_) {
    return "done";
  }
  return iteration_ == 0 ? "stageOne" : "stageTwo";
}

bool RivalSearch::advance(std::uint32_t iterations) {
  for (std::uint32_t i = 0; i < iterations && !done_; ++i) {
    ++iteration_;
    if (step()) {
      connect();
      done_ = true;
    }
  }
  return done_;
}

void RivalSearch::offer(const search::PaperLayout& beams, const Judgement& judgement) {
  if (judgement.cost() >= bestCost_) {
    return;
  }
  bestCost_ = judgement.cost();
  bestSums_ = beams.sums();
  best_.energy = bestCost_;
  best_.covers = beams.covers();
  best_.junctions.assign(problem_->graph.junctions.size(), {});
  best_.tallies = {};
  search::addPaperSums(bestSums_, &best_.tallies, false);
  ++improvements_;
}

//! The beam connection procedure, once for all.
void RivalSearch::connect() {
  layout::Layout layout(*problem_, *solver_);
  for (std::size_t r = 0; r < best_.covers.size(); ++r) {
    layout.setCover(static_cast<int>(r), best_.covers[r]);
  }
  layout.settleAll();
  layout.keep();
  best_.tallies = layout.tallies();
  search::addPaperSums(bestSums_, &best_.tallies, true);
  for (std::size_t j = 0; j < best_.junctions.size(); ++j) {
    best_.junctions[j] = layout.junction(static_cast<int>(j));
  }
  ++improvements_;
}

}  // namespace liftarm::rivals
