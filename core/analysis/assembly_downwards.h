#pragma once

#include <vector>

#include "analysis/assembly_units.h"

namespace liftarm::analysis {

//! \brief In how many pieces the units are that are there. \param there By unit, 0 or 1.
int countPieces(const std::vector<AssemblyUnit>& units, std::vector<char> there);

//! \brief The order of building that comes of taking apart from the top: of what can go, what
//! leaves no loose pieces, the highest of that, fasteners first. \details To take something away
//! makes nothing else harder to take, so that this comes to an end wherever parts come out one by
//! one. \return Units; nothing where they do not.
std::vector<int> orderDownwards(const std::vector<AssemblyUnit>& units);

}  // namespace liftarm::analysis
