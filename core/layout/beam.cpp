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

namespace {

//! Place in the run's list of junctions of the one where it meets another; -1: they do not meet.
int meetingPlace(const guide::GuidingGraph& graph, const guide::GuideRun& run, int mate) {
  for (std::size_t j = 0; j < run.junctions.size(); ++j) {
    const guide::Junction& junction = graph.junctions[static_cast<std::size_t>(run.junctions[j])];
    if (std::any_of(junction.incident.begin(),
                    junction.incident.end(),
                    [&](const guide::Incidence& i) { return i.run == mate; })) {
      return static_cast<int>(j);
    }
  }
  return -1;
}

}  // namespace

int commonJunction(const guide::GuidingGraph& graph, int run, int mate) {
  const guide::GuideRun& guideRun = graph.runs[static_cast<std::size_t>(run)];
  const int place = meetingPlace(graph, guideRun, mate);
  return place < 0 ? -1 : guideRun.junctions[static_cast<std::size_t>(place)];
}

int cornerIndex(const guide::GuidingGraph& graph, int run, int mate) {
  const guide::GuideRun& guideRun = graph.runs[static_cast<std::size_t>(run)];
  const int place = meetingPlace(graph, guideRun, mate);
  return place < 0 ? -1 : guideRun.junctionIndices[static_cast<std::size_t>(place)];
}

int partsOfBeam(int holes) {
  return holes == 4 || holes == 6 ? 2 : 1;
}

}  // namespace liftarm::layout
