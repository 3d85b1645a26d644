#pragma once

#include <cstdint>
#include <vector>

#include "base/rng.h"
#include "rivals/rivals.h"
#include "search/layout_search.h"
#include "search/paper_state.h"

namespace liftarm::rivals {

//! \brief Algorithm 1 as "a population-based search by finding N instead of one solutions in each
//! iteration and keeping the best K for generating candidates in the next iteration (we set N = 20
//! and K = 4)" (paper 5.3; \cite vanhentenryck_2007_population).
//! \details Read: it begins with K random layouts. In each iteration each of the K is modified N /
//! K times; a modification stands in for its parent where the Metropolis rule accepts it, else the
//! parent stays. The best K different ones by the objective go on. Temperatures, schedule and both
//! objectives are those of the paper's method.
class Population final : public search::LayoutSearch {
 public:
  static constexpr int kFound = 20;  //!< N
  static constexpr int kKept = 4;    //!< K

  Population(const layout::LayoutProblem& problem,
             layout::ConnectionSolver& solver,
             RivalOptions options);

  bool advance(std::uint32_t iterations) override;

  [[nodiscard]] bool done() const override { return done_; }

  [[nodiscard]] const search::LayoutSnapshot& best() const override { return best_; }

  [[nodiscard]] std::uint32_t improvements() const override { return improvements_; }

  [[nodiscard]] std::uint64_t iterations() const override { return iteration_; }

  [[nodiscard]] double temperature() const override { return temperature_; }

  [[nodiscard]] double fraction() const override;
  [[nodiscard]] const char* phase() const override;

 private:
  //! One solution of an iteration: a parent as it was, or with a change.
  struct Found {
    std::size_t parent = 0;
    search::CoverChanges changes;
    double energy = 0.0;
  };

  void begin();
  void useFullObjective();
  void iterate();
  [[nodiscard]] std::vector<Found> find();
  void goOnWith(const std::vector<Found>& chosen);
  void keepBest();

  const layout::LayoutProblem* problem_;
  layout::ConnectionSolver* solver_;
  search::PaperOptions options_;
  base::Rng rng_;
  std::vector<search::PaperState> states_;
  search::LayoutSnapshot best_;
  bool done_ = false;
  std::uint64_t iteration_ = 0;
  std::uint32_t improvements_ = 0;
  double temperature_;
};

}  // namespace liftarm::rivals
