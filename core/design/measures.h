#pragma once

#include <vector>

#include "mechanisms/mechanism_table.h"
#include "objective/objective.h"
#include "objective/symmetry_measure.h"
#include "search/layout_search.h"

namespace liftarm::design {

//! \brief The symmetries that a sketch names, as groups of runs.
std::vector<objective::SymmetryGroup> symmetryGroups(const guide::GuidingGraph& graph);

//! \brief All that the terms of the objective look at (paper 4.3), of one layout.
//! \param best May be without covers: then only its scale is known.
objective::Measures measuresOf(const layout::LayoutProblem& problem,
                               const mechanisms::MechanismTable& table,
                               const search::LayoutSnapshot& best);

}  // namespace liftarm::design
