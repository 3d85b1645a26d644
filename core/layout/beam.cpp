#include "layout/beam.h"

#include <algorithm>

namespace liftarm::layout {

InlinePins inlinePins(const guide::GuideRun& run, const Beam& a, const Beam& b) {
  InlinePins pins;
  const int first = std::max(a.start, b.start);
  const int last = std::min(a.last(), b.last());
  if (a.layer - b.layer != 1 && b.layer - a.layer != 1) {
    return pins;
  }
  for (int i = first; i <= last; ++i) {
    const bool junction = std::find(run.junctionIndices.begin(), run.junctionIndices.end(), i) !=
                          run.junctionIndices.end();
    if (!junction) {
      pins.nodes[pins.count == 0 ? 0 : 1] = i;
      pins.count = std::min(pins.count + 1, 2);
    }
  }
  return pins;
}

int cornerIndex(const guide::GuidingGraph& graph, int run, int mate) {
  const guide::GuideRun& guideRun = graph.runs[static_cast<std::size_t>(run)];
  for (std::size_t j = 0; j < guideRun.junctions.size(); ++j) {
    const guide::Junction& junction =
        graph.junctions[static_cast<std::size_t>(guideRun.junctions[j])];
    const bool meets = std::any_of(junction.incident.begin(),
                                   junction.incident.end(),
                                   [&](const guide::Incidence& i) { return i.run == mate; });
    if (meets) {
      return guideRun.junctionIndices[j];
    }
  }
  return -1;
}

int partsOfBeam(int holes) {
  return holes == 4 || holes == 6 ? 2 : 1;
}

}  // namespace liftarm::layout
