#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "design/settings.h"
#include "layout/keeps.h"
#include "layout/layout.h"
#include "mechanisms/mechanism_table.h"
#include "search/layout_search.h"
#include "sketch/sketch.h"

namespace liftarm::design {

//! \brief Rounds of each of its searches; whoever wants fewer of the search itself waits for no
//! reason.
inline constexpr std::uint32_t kRoundsOfBlame = 5;

//! \brief What of all that a sketch keeps leaves it without a whole layout.
//! \details Searched in counted moves, so no proof: all is left out first, and where that helps one
//! kept part, barred part or rule after the other, those nearest to the violations first.
//! \param failed The best layout that a search with all of it found. \return Nothing where leaving
//! all of it out does not help either.
std::optional<layout::KeepFault> findBlame(const sketch::Sketch& sketch,
                                           const layout::LayoutProblem& problem,
                                           const search::LayoutSnapshot& failed,
                                           const Settings& settings,
                                           const mechanisms::MechanismTable& table);

//! \brief The lines whose cover is not as the sketch wants it: a kept part is not there, or what
//! may not be is. \param covers By run of the problem, or none at all. \return One for each run, at
//! its middle.
std::vector<layout::KeepFault> findUnkept(const sketch::Sketch& sketch,
                                          const layout::LayoutProblem& problem,
                                          const std::vector<layout::Cover>& covers);

}  // namespace liftarm::design
