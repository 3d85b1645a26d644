#include "search/paper_layout.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "layout/bent_beam.h"
#include "layout/stack.h"

namespace liftarm::search {

namespace {

using guide::kMaxLayer;
using lattice::Axis;
using layout::Beam;
using layout::Cover;

unsigned bit(int layer) {
  return 1U << static_cast<unsigned>(layer + kMaxLayer);
}

bool hasHoleAt(const Beam& beam, int index) {
  return beam.start <= index && beam.last() >= index;
}

bool coversEdge(const Beam& beam, int edge) {
  return beam.start <= edge && beam.last() > edge;
}

void addTo(PaperSums* sums, const PaperSums& other, int sign) {
  sums->beams += sign * other.beams;
  sums->holes += sign * other.holes;
  sums->layerSquares += sign * other.layerSquares;
  sums->gaps += sign * other.gaps;
  sums->ownCollisions += sign * other.ownCollisions;
  sums->ownFailures += sign * other.ownFailures;
  sums->uncovered += sign * other.uncovered;
}

bool sharePin(const layout::InlinePins& a, const layout::InlinePins& b) {
  return std::any_of(a.begin(), a.end(), [&](int node) { return b.has(node); });
}

}  // namespace

void addPaperSums(const PaperSums& sums, layout::Tallies* tallies, bool connected) {
  tallies->beams = sums.beams;
  tallies->holes = sums.holes;
  tallies->layerSquares = sums.layerSquares;
  tallies->gaps = sums.gaps;
  tallies->collisions = sums.ownCollisions + (connected ? tallies->collisions : 0);
  tallies->failedConnections =
      sums.ownFailures + sums.uncovered + (connected ? tallies->failedConnections : 0);
}

PaperLayout::PaperLayout(const layout::LayoutProblem& problem,
                         PaperOrientation orientation,
                         std::vector<int> lengths)
    : problem_(&problem),
      lengths_(std::move(lengths)),
      covers_(problem.graph.runs.size()),
      axes_(std::move(orientation.runs)),
      junctionAxes_(std::move(orientation.junctions)),
      coverable_(problem.graph.runs.size()),
      runSums_(problem.graph.runs.size()),
      junctionGaps_(problem.graph.junctions.size(), 0),
      isTouched_(problem.graph.runs.size(), 0) {
  for (std::size_t r = 0; r < covers_.size(); ++r) {
    const guide::GuideRun& run = problem.graph.runs[r];
    covers_[r].axis = axes_[r];
    junctionAt_.emplace_back(run.nodes.size(), -1);
    for (std::size_t j = 0; j < run.junctions.size(); ++j) {
      junctionAt_[r][at(run.junctionIndices[j])] = run.junctions[j];
    }
    markCoverable(static_cast<int>(r));
  }
  for (std::size_t r = 0; r < covers_.size(); ++r) {
    touch(static_cast<int>(r));
  }
  settle();
  keep();
}

void PaperLayout::touch(int run) {
  if (isTouched_[at(run)] == 0) {
    isTouched_[at(run)] = 1;
    touched_.push_back(run);
    savedCovers_.push_back(covers_[at(run)]);
  }
}

void PaperLayout::markCoverable(int run) {
  const guide::GuideRun& guideRun = problem_->graph.runs[at(run)];
  std::vector<std::uint8_t>& edges = coverable_[at(run)];
  edges.assign(at(guideRun.edgeCount()), 1);
  for (int e = 0; e < guideRun.edgeCount() && guideRun.principal; ++e) {
    for (const int end : {e, e + 1}) {
      const int junction = junctionAt_[at(run)][at(end)];
      if (junction >= 0 && junctionAxes_[at(junction)] != axes_[at(run)]) {
        edges[at(e)] = 0;
      }
    }
  }
}

bool PaperLayout::covered(int run, int edge) const {
  const std::vector<Beam>& beams = covers_[at(run)].beams;
  return std::any_of(
      beams.begin(), beams.end(), [&](const Beam& beam) { return coversEdge(beam, edge); });
}

unsigned PaperLayout::ownLayers(int run, int index) const {
  unsigned layers = 0;
  for (const Beam& beam : covers_[at(run)].beams) {
    layers |= hasHoleAt(beam, index) ? bit(beam.layer) : 0U;
  }
  return layers;
}

unsigned PaperLayout::junctionLayers(int junction) const {
  unsigned layers = 0;
  for (const guide::Incidence& incidence : problem_->graph.junctions[at(junction)].incident) {
    if (axes_[at(incidence.run)] == junctionAxes_[at(junction)]) {
      layers |= ownLayers(incidence.run, incidence.index);
    }
  }
  return layers;
}

unsigned PaperLayout::layersAt(int run, int index) const {
  const int junction = junctionAt_[at(run)][at(index)];
  return junction >= 0 && junctionAxes_[at(junction)] == axes_[at(run)] ? junctionLayers(junction)
                                                                        : ownLayers(run, index);
}

void PaperLayout::insert(int run, const Beam& beam) {
  touch(run);
  std::vector<Beam>& beams = covers_[at(run)].beams;
  const auto place = std::find_if(beams.begin(), beams.end(), [&](const Beam& other) {
    return other.start > beam.start || (other.start == beam.start && other.last() > beam.last());
  });
  beams.insert(place, beam);
}

void PaperLayout::add(const PaperPlacement& placement, int layer) {
  const int form = placement.mate >= 0 ? layout::bentBeamIndex(kCornerBeam) : -1;
  insert(placement.run, {placement.start, placement.holes, layer, placement.mate, form});
  if (placement.mate >= 0) {
    insert(placement.mate, {placement.mateStart, placement.mateHoles, layer, placement.run, form});
  }
}

void PaperLayout::erase(int run, const Beam& beam) {
  const auto drop = [&](int from, const Beam& which) {
    touch(from);
    std::vector<Beam>& beams = covers_[at(from)].beams;
    beams.erase(std::find(beams.begin(), beams.end(), which));
  };
  const Beam taken = beam;  // what the reference names goes
  drop(run, taken);
  if (taken.mate < 0) {
    return;
  }
  for (const Beam& arm : covers_[at(taken.mate)].beams) {
    if (arm.mate == run) {
      drop(taken.mate, Beam{arm});
      return;
    }
  }
}

void PaperLayout::eraseStopping(int run, int index) {
  for (std::size_t b = covers_[at(run)].beams.size(); b-- > 0;) {
    const Beam& beam = covers_[at(run)].beams[b];
    if (beam.start == index || beam.last() == index) {
      erase(run, beam);
    }
  }
}

void PaperLayout::removeAround(int run, int edge) {
  for (std::size_t b = covers_[at(run)].beams.size(); b-- > 0;) {
    const Beam& beam = covers_[at(run)].beams[b];
    if (coversEdge(beam, edge)) {
      erase(run, beam);
    }
  }
  for (const int index : {edge, edge + 1}) {
    eraseStopping(run, index);
    const int junction = junctionAt_[at(run)][at(index)];
    if (junction < 0) {
      continue;
    }
    for (const guide::Incidence& other : problem_->graph.junctions[at(junction)].incident) {
      if (other.run != run && axes_[at(other.run)] == axes_[at(run)]) {
        eraseStopping(other.run, other.index);
      }
    }
  }
}

//! Gives a run another hole axis; its junctions' nodes follow. Returns it and the runs it meets.
std::vector<int> PaperLayout::changeAxis(int run, Axis axis) {
  const guide::GuidingGraph& graph = problem_->graph;
  if (!turned_) {
    savedAxes_ = junctionAxes_;
    turned_ = true;
  }
  axes_[at(run)] = axis;
  covers_[at(run)].axis = axis;
  std::vector<int> met{run};
  for (const int j : graph.runs[at(run)].junctions) {
    junctionAxes_[at(j)] = junctionAxis(graph, axes_, graph.junctions[at(j)]);
    for (const guide::Incidence& incidence : graph.junctions[at(j)].incident) {
      met.push_back(incidence.run);
    }
  }
  return met;
}

void PaperLayout::setCover(int run, const Cover& cover) {
  touch(run);
  covers_[at(run)].beams = cover.beams;
  if (cover.axis != axes_[at(run)]) {
    for (const int other : changeAxis(run, cover.axis)) {
      touch(other);
      markCoverable(other);
    }
  }
}

void PaperLayout::turn(int run, Axis axis) {
  touch(run);
  while (!covers_[at(run)].beams.empty()) {
    erase(run, covers_[at(run)].beams.back());
  }
  for (const int other : changeAxis(run, axis)) {
    touch(other);
    markCoverable(other);
    for (std::size_t b = covers_[at(other)].beams.size(); b-- > 0;) {
      const Beam& beam = covers_[at(other)].beams[b];
      if (!fits(other, beam.start, beam.holes)) {
        erase(other, beam);
        b = covers_[at(other)].beams.size();  // an L beam's other arm may have gone from here
      }
    }
  }
}

//! Clusters of beams, less one, of each stretch between edges that cannot be covered; and pins in
//! line that would have to share a hole.
int PaperLayout::failuresOf(int run) const {
  const std::vector<Beam>& beams = covers_[at(run)].beams;
  const guide::GuideRun& guideRun = problem_->graph.runs[at(run)];
  std::vector<std::size_t> cluster(beams.size());
  std::iota(cluster.begin(), cluster.end(), 0U);
  const auto join = [&](std::size_t a, std::size_t b) {
    const std::size_t from = cluster[a];
    std::replace(cluster.begin(), cluster.end(), from, cluster[b]);
  };
  int failures = 0;
  layout::InlinePins pinsBefore;
  for (std::size_t b = 0; b < beams.size(); ++b) {
    layout::InlinePins pins;
    if (b > 0) {
      pins = layout::inlinePins(guideRun, beams[b - 1], beams[b]);
      failures += sharePin(pins, pinsBefore) ? 1 : 0;
    }
    for (std::size_t a = 0; a < b; ++a) {
      const bool atJunction = std::any_of(
          guideRun.junctionIndices.begin(), guideRun.junctionIndices.end(), [&](int index) {
            return hasHoleAt(beams[a], index) && hasHoleAt(beams[b], index);
          });
      const bool apart = !fits(run, beams[a].start, beams[b].last() - beams[a].start + 1);
      if (atJunction || apart || (a + 1 == b && pins.count > 0)) {
        join(a, b);
      }
    }
    pinsBefore = pins;
  }
  for (std::size_t b = 0; b < beams.size(); ++b) {
    failures +=
        std::find(cluster.begin(), cluster.begin() + static_cast<std::ptrdiff_t>(b), cluster[b]) ==
                cluster.begin() + static_cast<std::ptrdiff_t>(b)
            ? 1
            : 0;
  }
  return beams.empty() ? 0 : failures - 1;
}

PaperSums PaperLayout::sumsOfRun(int run) const {
  PaperSums sums;
  const std::vector<Beam>& beams = covers_[at(run)].beams;
  for (std::size_t b = 0; b < beams.size(); ++b) {
    const Beam& beam = beams[b];
    const bool second = beam.mate >= 0 && beam.mate < run;  // its corner is counted on the other
    const int holes = second ? beam.holes - 1 : beam.holes;
    sums.beams += second ? 0 : layout::partsOfBeam(beam.holes);
    sums.holes += holes;
    sums.layerSquares += holes * beam.layer * beam.layer;
    for (std::size_t a = 0; a < b; ++a) {
      const bool clash = beams[a].layer == beam.layer && beams[a].last() >= beam.start;
      sums.ownCollisions += clash ? 1 : 0;
    }
  }
  const std::vector<int>& junctions = junctionAt_[at(run)];
  for (std::size_t i = 0; i < junctions.size(); ++i) {
    if (junctions[i] < 0) {
      sums.gaps += layout::stackFaults(ownLayers(run, static_cast<int>(i))).gaps;
    }
  }
  sums.ownFailures = failuresOf(run);
  sums.uncovered = uncoveredBefore(run).back();
  return sums;
}

void PaperLayout::settle() {
  for (const int run : touched_) {
    addTo(&sums_, runSums_[at(run)], -1);
    runSums_[at(run)] = sumsOfRun(run);
    addTo(&sums_, runSums_[at(run)], 1);
    for (const int j : problem_->graph.runs[at(run)].junctions) {
      sums_.gaps -= junctionGaps_[at(j)];
      junctionGaps_[at(j)] = layout::stackFaults(junctionLayers(j)).gaps;
      sums_.gaps += junctionGaps_[at(j)];
    }
  }
}

void PaperLayout::keep() {
  for (const int run : touched_) {
    isTouched_[at(run)] = 0;
  }
  touched_.clear();
  savedCovers_.clear();
  turned_ = false;
}

void PaperLayout::revert() {
  for (std::size_t i = 0; i < touched_.size(); ++i) {
    covers_[at(touched_[i])] = std::move(savedCovers_[i]);
    axes_[at(touched_[i])] = covers_[at(touched_[i])].axis;
  }
  if (turned_) {
    junctionAxes_ = std::move(savedAxes_);
    for (const int run : touched_) {
      markCoverable(run);
    }
  }
  settle();
  keep();
}

}  // namespace liftarm::search
