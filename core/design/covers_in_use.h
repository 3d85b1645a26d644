#pragma once

#include "design/settings.h"
#include "search/cover_table.h"

namespace liftarm::design {

//! \brief What the search that the settings name may lay for a problem.
search::CoverTable coversInUse(const layout::LayoutProblem& problem, const Settings& settings);

}  // namespace liftarm::design
