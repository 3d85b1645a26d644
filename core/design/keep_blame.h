#pragma once

#include <cstdint>
#include <optional>

#include "design/settings.h"
#include "layout/keeps.h"
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

}  // namespace liftarm::design
