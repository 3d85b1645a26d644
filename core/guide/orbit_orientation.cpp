#include <algorithm>

#include "base/det_math.h"
#include "base/index.h"
#include "guide/orbits.h"

namespace liftarm::guide {

namespace {

using base::at;
using lattice::Axis;

constexpr int kMostStarts = 12;  // each is dearer than one without orbits
constexpr int kSweeps = 12;
constexpr double kOrbitsFirst = 1.5;
constexpr double kOrbitsLast = 0.1;
constexpr double kOrbitsCooling = 0.6;
constexpr double kPinnedCost = 4.0;  // two runs on layer 0 that cross
constexpr double kSameCost = 1e-9;

void setAxis(const Orbits& orbits, int run, Axis axis, Orientation* orientation) {
  (*orientation)[at(run)] = axis;
  for (const RunImage& image : orbits.images(run)) {
    if (image.run != run) {
      (*orientation)[at(image.run)] = lattice::axisFromIndex(image.axes[at(lattice::index(axis))]);
    }
  }
}

double costOf(const GuidingGraph& graph, const Orbits& orbits, const Orientation& orientation) {
  double cost = orientationCost(graph, orientation);
  for (const Junction& junction : graph.junctions) {
    std::array<int, 3> pinned{0, 0, 0};
    for (const Incidence& incidence : junction.incident) {
      const Axis axis = orientation[at(incidence.run)];
      pinned[at(lattice::index(axis))] += orbits.binding(incidence.run, axis).pinned ? 1 : 0;
    }
    for (const int count : pinned) {
      cost += count > 1 ? kPinnedCost * static_cast<double>(count - 1) : 0.0;
    }
  }
  return cost;
}

//! The hole axes that the symmetries leave a run.
std::vector<Axis> choicesOf(const GuidingGraph& graph, const Orbits& orbits, int run) {
  std::vector<Axis> choices;
  for (const Axis axis : graph.runs[at(run)].axes) {
    if (orbits.allows(run, axis)) {
      choices.push_back(axis);
    }
  }
  return choices.empty() ? graph.runs[at(run)].axes : choices;
}

}  // namespace

Orientation estimateOrientation(const GuidingGraph& graph,
                                const Orbits& orbits,
                                int starts,
                                base::Rng* rng) {
  std::vector<int> free;
  Orientation best(graph.runs.size(), Axis::kX);
  std::vector<std::vector<Axis>> choices;
  for (std::size_t r = 0; r < graph.runs.size(); ++r) {
    const int run = static_cast<int>(r);
    choices.push_back(choicesOf(graph, orbits, run));
    if (orbits.representative(run) == run) {
      setAxis(orbits, run, choices[r][0], &best);
      if (choices[r].size() > 1) {
        free.push_back(run);
      }
    }
  }
  double bestCost = costOf(graph, orbits, best);
  for (int start = 0; start < std::min(starts, kMostStarts); ++start) {
    Orientation orientation = best;
    for (const int run : free) {
      setAxis(orbits, run, choices[at(run)][rng->below(2)], &orientation);
    }
    double cost = costOf(graph, orbits, orientation);
    double temperature = kOrbitsFirst;
    for (int sweep = 0; sweep < kSweeps; ++sweep, temperature *= kOrbitsCooling) {
      for (const int run : free) {
        const Axis before = orientation[at(run)];
        const std::vector<Axis>& axes = choices[at(run)];
        setAxis(orbits, run, axes[0] == before ? axes[1] : axes[0], &orientation);
        const double delta = costOf(graph, orbits, orientation) - cost;
        if (delta <= 0.0 ||
            (temperature > kOrbitsLast && rng->unit() < base::detExp(-delta / temperature))) {
          cost += delta;
        } else {
          setAxis(orbits, run, before, &orientation);
        }
      }
    }
    if (cost < bestCost - kSameCost) {
      best = orientation;
      bestCost = cost;
    }
  }
  return best;
}

}  // namespace liftarm::guide
