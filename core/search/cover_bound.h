#pragma once

#include "search/cover_table.h"

namespace liftarm::search {

//! \brief Fewest beams and axles along lines of any layout that chooses from a table, at least:
//! quick, and never too high whatever the layers are. \details Each edge (and each run, which needs
//! a cover even where all its edges may be bridged) is given a price p >= 0. A layout pays for all
//! of them, and a cover takes at most its parts off what its edges cost, so
//!   beams + axles >= sum p + sum over covers of min(0, parts - prices of what it covers)
//! for any prices. Good ones are found by subgradient steps \cite held_1971_traveling, rounded to
//! whole numbers over 2^16, and summed up exactly; pieces of the table that share no cover are
//! bounded one by one, each rounded up. Who owns how many parts is not looked at
//! (docs/lower-bound.md has the proof, and the exact minimum).
int coverLowerBound(const CoverTable& table);

}  // namespace liftarm::search
