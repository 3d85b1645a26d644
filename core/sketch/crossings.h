#pragma once

#include <vector>

#include "sketch/arrangement.h"

namespace liftarm::sketch {

//! More than this many are not listed: a drawing with so many has no use for the rest.
inline constexpr std::size_t kMaxCrossings = 10000;

//! \brief Finds runs that meet within kSamePoint where not both have a node, or that overlap out of
//! step. \details Each pair of runs once, ordered by their numbers. Only unit edges in one cell of
//! the lattice are compared, so that the time grows with the length of the lines. \pre nodes and
//! runs of the arrangement are complete.
std::vector<OffNodeCrossing> findOffNodeCrossings(const Arrangement& arrangement);

}  // namespace liftarm::sketch
