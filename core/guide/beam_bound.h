#pragma once

#include <vector>

#include "guide/guiding_graph.h"

namespace liftarm::guide {

//! \brief Longest beam, in edges.
inline constexpr int kLongestBeam = 14;

//! \brief Fewest straight beams that can cover a run when edges next to the marked nodes may be
//! left to a mechanism; at least one. \param bridged By node index: whether a mechanism may bridge
//! the edges next to it. \details Greedy from one end, which is optimal since every length up to
//! the longest can be reached by beams that overlap or stick out: a valid lower bound whatever the
//! layers are.
int fewestBeams(const GuideRun& run, const std::vector<bool>& bridged);

//! \brief The same for a run of this graph, with its bridgeable junctions marked.
int fewestBeams(const GuidingGraph& graph, const GuideRun& run);

//! \brief Lower bound on the number of straight beams of any layout of this graph (report key
//! beamsLowerBound): the sum of fewestBeams over all runs, where a mechanism may bridge the edges
//! next to a junction whose runs no single hole axis can serve (Junction::bridgeable). \details
//! Valid for every layout that covers all other edges, whatever its layers and hole axes are. Beams
//! are straight, so none serves two runs; L and T beams can go below (docs/lower-bound.md).
int beamsLowerBound(const GuidingGraph& graph);

}  // namespace liftarm::guide
