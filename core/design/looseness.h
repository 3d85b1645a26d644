#pragma once

#include <functional>

#include "mechanisms/mechanism_table.h"
#include "search/layout_search.h"
#include "sketch/sketch.h"

namespace liftarm::design {

//! \brief Whether a layout's model is buildable: all of DESIGN 5, by the model wing. \pre problem,
//! table and sketch outlive the function.
std::function<bool(const search::LayoutSnapshot&)> makeBuildable(
    const layout::LayoutProblem& problem,
    const mechanisms::MechanismTable& table,
    const sketch::Sketch& sketch);

//! \brief How often the model of a layout fails to stand as the drawing does: parts below the base,
//! feet in the air, falling over (DESIGN 5b.2).
int countStandingFaults(const layout::LayoutProblem& problem,
                        const mechanisms::MechanismTable& table,
                        const sketch::Sketch& sketch,
                        const search::LayoutSnapshot& snapshot);

//! \brief How many ways the model of a layout can move that friction does not hold, its joints
//! included. \pre problem and table outlive the function.
std::function<int(const search::LayoutSnapshot&)> makeHeld(const layout::LayoutProblem& problem,
                                                           const mechanisms::MechanismTable& table);

}  // namespace liftarm::design
