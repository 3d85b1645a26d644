#include "guide/orientation.h"

#include <algorithm>

#include "guide/beam_bound.h"

namespace liftarm::guide {

namespace {

using lattice::Axis;

constexpr double kBeamWeight = 0.5;
constexpr int kMaxSweeps = 30;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

int axesAt(const Junction& junction, const Orientation& orientation) {
  unsigned seen = 0;
  for (const Incidence& incidence : junction.incident) {
    seen |= 1U << static_cast<unsigned>(lattice::index(orientation[at(incidence.run)]));
  }
  return static_cast<int>((seen & 1U) + (seen >> 1U & 1U) + (seen >> 2U & 1U));
}

bool fitsOneBeam(int edges) {
  return edges == 1 || (edges % 2 == 0 && edges <= kLongestBeam);
}

//! Beams of a run under this orientation; one more when a single beam would have to stick out.
double beamsOf(const GuidingGraph& graph, int runId) {
  const GuideRun& run = graph.runs[at(runId)];
  std::vector<bool> bridged(run.nodes.size(), false);
  for (std::size_t j = 0; j < run.junctions.size(); ++j) {
    const Junction& junction = graph.junctions[at(run.junctions[j])];
    bridged[at(run.junctionIndices[j])] = mayBridge(run, junction);
  }
  const int fewest = fewestBeams(run, bridged);
  if (fewest > 1) {
    return static_cast<double>(fewest);
  }
  const int edges = run.edgeCount();
  const int skips = (bridged.front() ? 1 : 0) + (bridged.back() ? 1 : 0);
  bool fits = false;
  for (int s = 0; s <= skips; ++s) {
    fits = fits || fitsOneBeam(edges - s);
  }
  return fits ? 1.0 : 1.5;
}

//! Cost of all that depends on one run's axis: its junctions, and the beams of the runs that meet
//! there.
double costAround(const GuidingGraph& graph, const Orientation& orientation, int runId) {
  double cost = kBeamWeight * beamsOf(graph, runId);
  for (const int j : graph.runs[at(runId)].junctions) {
    const Junction& junction = graph.junctions[at(j)];
    cost += static_cast<double>(axesAt(junction, orientation) - 1);
    for (const Incidence& incidence : junction.incident) {
      if (incidence.run != runId) {
        cost += kBeamWeight * beamsOf(graph, incidence.run);
      }
    }
  }
  return cost;
}

void descend(const GuidingGraph& graph, Orientation* orientation, base::Rng* rng) {
  std::vector<int> free;
  for (std::size_t r = 0; r < graph.runs.size(); ++r) {
    if (graph.runs[r].axes.size() > 1) {
      free.push_back(static_cast<int>(r));
    }
  }
  bool changed = !free.empty();
  for (int sweep = 0; changed && sweep < kMaxSweeps; ++sweep) {
    changed = false;
    for (std::size_t i = free.size(); i > 1; --i) {
      std::swap(free[i - 1], free[rng->below(static_cast<std::uint32_t>(i))]);
    }
    for (const int run : free) {
      const Axis before = (*orientation)[at(run)];
      Axis best = before;
      double bestCost = costAround(graph, *orientation, run);
      for (const Axis axis : graph.runs[at(run)].axes) {
        (*orientation)[at(run)] = axis;
        const double cost = costAround(graph, *orientation, run);
        if (axis != before && (cost < bestCost - 1e-9 ||
                               (cost < bestCost + 1e-9 && rng->below(4) == 0 && sweep < 5))) {
          best = axis;
          bestCost = cost;
        }
      }
      (*orientation)[at(run)] = best;
      changed = changed || best != before;
    }
  }
}

}  // namespace

double orientationCost(const GuidingGraph& graph, const Orientation& orientation) {
  double cost = 0.0;
  for (const Junction& junction : graph.junctions) {
    cost += static_cast<double>(axesAt(junction, orientation) - 1);
  }
  for (std::size_t r = 0; r < graph.runs.size(); ++r) {
    cost += kBeamWeight * beamsOf(graph, static_cast<int>(r));
  }
  return cost;
}

Orientation estimateOrientation(const GuidingGraph& graph, int starts, base::Rng* rng) {
  Orientation best;
  double bestCost = 0.0;
  for (int start = 0; start < starts; ++start) {
    Orientation orientation;
    for (const GuideRun& run : graph.runs) {
      const auto choices = static_cast<std::uint32_t>(run.axes.size());
      orientation.push_back(run.axes[choices > 1 ? rng->below(choices) : 0]);
    }
    descend(graph, &orientation, rng);
    const double cost = orientationCost(graph, orientation);
    if (best.empty() || cost < bestCost) {
      best = orientation;
      bestCost = cost;
    }
  }
  return best;
}

}  // namespace liftarm::guide
