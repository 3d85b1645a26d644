#include "layout/beam.h"

#include <algorithm>
#include <cmath>

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
    if (!junction && a.hasHoleAt(i) && b.hasHoleAt(i)) {
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

int sharedHoles(const Beam& a, const Beam& b) {
  const int first = std::max(a.start, b.start);
  const int last = std::min(a.last(), b.last());
  if ((a.crossed | b.crossed) == 0U) {
    return last - first + 1;
  }
  int holes = 0;
  for (int i = first; i <= last; ++i) {
    holes += a.hasHoleAt(i) && b.hasHoleAt(i) ? 1 : 0;
  }
  return holes;
}

lattice::Axis axisAcross(const guide::GuideRun& run, lattice::Axis axis) {
  int along = 0;
  for (int k = 0; k < 3; ++k) {
    along = std::abs(run.direction[k]) > 0.5 ? k : along;
  }
  return lattice::axisFromIndex(3 - along - lattice::index(axis));
}

int partsOfBeam(int holes) {
  return holes == 4 || holes == 6 ? 2 : 1;
}

}  // namespace liftarm::layout
