#include "guide/beam_bound.h"

#include <algorithm>

namespace liftarm::guide {

int fewestBeams(const GuideRun& run, const std::vector<bool>& bridged) {
  const int edges = run.edgeCount();
  int beams = 0;
  int next = 0;
  while (next < edges) {
    const auto here = static_cast<std::size_t>(next);
    if (bridged[here] || bridged[here + 1]) {
      ++next;
      continue;
    }
    ++beams;
    next += kLongestBeam;
  }
  return std::max(beams, 1);
}

int fewestBeams(const GuidingGraph& graph, const GuideRun& run) {
  std::vector<bool> bridged(run.nodes.size(), false);
  for (std::size_t j = 0; j < run.junctions.size(); ++j) {
    const Junction& junction = graph.junctions[static_cast<std::size_t>(run.junctions[j])];
    bridged[static_cast<std::size_t>(run.junctionIndices[j])] = mayBridge(run, junction);
  }
  return fewestBeams(run, bridged);
}

}  // namespace liftarm::guide
