#pragma once

#include <vector>

#include "analysis/coverage.h"

namespace liftarm::analysis {

//! \brief Leaves each module of a beam with one edge only: without this, a beam between two
//! parallel lines would stand for both. \details A maximum bipartite matching of edges with modules
//! of beams by augmenting paths
//! (\cite kuhn_1955_hungarian), edges and modules first that are on the layer that the model
//! says, then those with the smallest offsets. Modules that no edge needs stay with the first of
//! theirs, but not where the model says that their beam covers others. Edges that two lines share
//! count as one.
void matchCovers(std::vector<EdgeCover>& edges);

}  // namespace liftarm::analysis
