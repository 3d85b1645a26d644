#pragma once

#include <vector>

#include "base/rng.h"
#include "guide/guiding_graph.h"

namespace liftarm::guide {

//! \brief A hole axis for each run.
using Orientation = std::vector<lattice::Axis>;

//! \brief What stage one minimises: at each junction the number of different hole axes less one
//! (adjacent node pairs that differ, paper 5.1). The fewest beams that cover the runs (DESIGN 7)
//! are the same for all: where a mechanism may bridge an edge does not depend on the axes chosen.
double orientationCost(const GuidingGraph& graph, const Orientation& orientation);

//! \brief Stage one (paper 5.1): simulated annealing from many random starts, the best result kept.
//! \param starts Number of random starts, at least 1.
Orientation estimateOrientation(const GuidingGraph& graph, int starts, base::Rng* rng);

}  // namespace liftarm::guide
