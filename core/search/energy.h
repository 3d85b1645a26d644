#pragma once

#include <string_view>

#include "layout/layout.h"
#include "objective/objective.h"

namespace liftarm::search {

//! \brief The weight of a term of the objective, by its name. \pre There is such a term.
double weightOf(const objective::Weights& weights, std::string_view term);

//! \brief What a search minimises: the objective, with violations weighted by their places, parts
//! beyond those owned, and, while it makes a layout stiff, freedoms.
class Energy {
 public:
  Energy(const layout::LayoutProblem& problem, const objective::Weights& weights);

  //! \brief What the objective says without its hard conditions.
  [[nodiscard]] double soft(const layout::Tallies& tallies) const;

  //! \brief The same, with what freedoms cost now.
  [[nodiscard]] double plain(const layout::Tallies& tallies, int freedoms) const {
    return soft(tallies) + freedomCost_ * freedoms;
  }

  //! \brief Of a layout that needs `missing` parts which nobody owns.
  [[nodiscard]] double of(const layout::Layout& layout, int missing, int freedoms) const;

  //! \brief What each freedom costs from now on.
  void setFreedomCost(double cost) { freedomCost_ = cost; }

 private:
  mutable objective::Measures measures_;  // reused: the tallies change, the scale does not
  objective::Weights softWeights_;
  double violationWeight_;
  double freedomCost_ = 0.0;
};

}  // namespace liftarm::search
