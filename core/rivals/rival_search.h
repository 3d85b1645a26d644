#pragma once

#include <cstdint>
#include <limits>

#include "base/rng.h"
#include "rivals/cover_judge.h"
#include "rivals/rivals.h"
#include "search/layout_search.h"
#include "search/paper_layout.h"
#include "search/paper_operator.h"

namespace liftarm::rivals {

//! \brief A rival that lays beams first and joins those of its best layout at the end.
class RivalSearch : public search::LayoutSearch {
 public:
  RivalSearch(const layout::LayoutProblem& problem,
              layout::ConnectionSolver& solver,
              RivalOptions options);

  bool advance(std::uint32_t iterations) final;

  [[nodiscard]] bool done() const final { return done_; }

  [[nodiscard]] const search::LayoutSnapshot& best() const final { return best_; }

  [[nodiscard]] std::uint32_t improvements() const final { return improvements_; }

  [[nodiscard]] std::uint64_t iterations() const final { return iteration_; }

  [[nodiscard]] double temperature() const final { return 0.0; }

  [[nodiscard]] double fraction() const final;
  [[nodiscard]] const char* phase() const final;

 protected:
  //! \brief The next step. \return True when there is none after it.
  virtual bool step() = 0;

  //! \brief How much is done, 0 to 1.
  [[nodiscard]] virtual double share() const = 0;

  //! \brief Takes a layout as the best one where it costs less than that.
  void offer(const search::PaperLayout& beams, const Judgement& judgement);

  [[nodiscard]] const layout::LayoutProblem& problem() const { return *problem_; }

  [[nodiscard]] const RivalOptions& options() const { return options_; }

  base::Rng* rng() { return &rng_; }

  search::PaperOperator& paperOperator() { return operator_; }

  //! \brief The layout that the rival works on: with the hole axes of the paper's stage one,
  //! without beams at first.
  search::PaperLayout& beams() { return beams_; }

  [[nodiscard]] const search::PaperLayout& beams() const { return beams_; }

  CoverJudge& judge() { return judge_; }

 private:
  void connect();

  const layout::LayoutProblem* problem_;
  layout::ConnectionSolver* solver_;
  RivalOptions options_;
  base::Rng rng_;
  search::PaperOperator operator_;
  search::PaperLayout beams_;
  CoverJudge judge_;
  search::LayoutSnapshot best_;
  search::PaperSums bestSums_;
  double bestCost_ = std::numeric_limits<double>::infinity();
  std::uint64_t iteration_ = 0;
  std::uint32_t improvements_ = 0;
  bool done_ = false;
};

}  // namespace liftarm::rivals
