#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/rng.h"
#include "layout/components.h"
#include "objective/objective.h"
#include "objective/symmetry_measure.h"
#include "search/layout_search.h"
#include "search/paper_layout.h"
#include "search/paper_operator.h"

namespace liftarm::search {

//! \brief What a PaperState needs to know.
struct PaperStateOptions {
  bool corners = true;  //!< whether L beams may be used
  std::vector<int> lengths{2, 3, 5, 6, 7, 9, 11, 13, 15};
  objective::Weights weights = objective::paperWeights(objective::Preset::kSimple);
};

//! \brief The covers of some runs: one layout's difference from another.
using CoverChanges = std::vector<std::pair<int, layout::Cover>>;

//! \brief A layout under the paper's operator with its objective (4.3), first the simplified one,
//! then the full one with all connections. \details A change is proposed, looked at, then accepted
//! or rejected. Copies share the random numbers, problem and solver of the first.
class PaperState {
 public:
  //! \brief Stage one and a random first layout. \pre problem, solver and rng outlive this.
  PaperState(const layout::LayoutProblem& problem,
             layout::ConnectionSolver& solver,
             const PaperStateOptions& options,
             base::Rng* rng);

  //! \brief Goes over to the full objective; energies before and after cannot be compared.
  void useFullObjective();

  [[nodiscard]] bool full() const { return full_; }

  //! \brief Applies the layout modification operator once.
  void propose();

  //! \brief Proposes a change that another state with these beams proposed.
  void propose(const CoverChanges& changes);

  //! \brief What the proposal changed.
  [[nodiscard]] CoverChanges changes() const;

  //! \brief Of the last accepted layout, and of the proposal.
  [[nodiscard]] double energy() const { return energy_; }

  [[nodiscard]] double proposedEnergy() const { return proposed_; }

  void accept();
  void reject();

  //! \brief Of the accepted layout; violations count in the full objective only.
  [[nodiscard]] int violations() const { return full_ ? measures_.tallies.violations() : 0; }

  [[nodiscard]] LayoutSnapshot snapshot() const;

 private:
  void settle();
  void measure();
  [[nodiscard]] double objective();

  const layout::LayoutProblem* problem_;
  objective::Weights weights_;
  objective::Weights simpleWeights_;
  PaperOperator operator_;
  layout::Layout layout_;
  PaperLayout beams_;
  std::vector<objective::SymmetryGroup> symmetries_;
  objective::Measures measures_;
  objective::Measures before_;  // the proposal
  layout::Components components_;
  bool full_ = false;
  double energy_ = 0.0;
  double proposed_ = 0.0;
};

}  // namespace liftarm::search
