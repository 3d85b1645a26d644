#pragma once

#include <vector>

#include "analysis/coverage.h"

namespace liftarm::analysis {

//! \brief Leaves each module of a beam with one edge only: without this, a beam between two
//! parallel lines would stand for both. \details A maximum bipartite matching of edges with modules
//! of beams by augmenting paths
//! (\cite kuhn_1955_hungarian), edges and modules with the smallest offsets first. Modules that no
//! edge needs stay with their nearest edge. Edges that two lines share count as one.
void matchCovers(std::vector<EdgeCover>& edges);

}  // namespace liftarm::analysis
