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
//! layers are. Bent beams and frames can do with less (search/cover_bound.h).
int fewestBeams(const GuideRun& run, const std::vector<bool>& bridged);

//! \brief The same for a run of this graph, with its bridgeable junctions marked.
int fewestBeams(const GuidingGraph& graph, const GuideRun& run);

}  // namespace liftarm::guide
