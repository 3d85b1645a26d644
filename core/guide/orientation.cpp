#include "guide/orientation.h"

#include <algorithm>

#include "base/det_math.h"
#include "base/index.h"

namespace liftarm::guide {

namespace {

using base::at;
using lattice::Axis;

constexpr int kMaxSweeps = 30;
constexpr double kSame = 1e-9;
// The paper's 2000 to 0.01 is a random walk nearly all the way: costs differ by about one (DESIGN
// 7).
constexpr double kFirstTemperature = 1.5;
constexpr double kLastTemperature = 0.1;
constexpr double kCooling = 0.75;

int axesAt(const Junction& junction, const Orientation& orientation) {
  unsigned seen = 0;
  for (const Incidence& incidence : junction.incident) {
    seen |= 1U << static_cast<unsigned>(lattice::index(orientation[at(incidence.run)]));
  }
  return static_cast<int>((seen & 1U) + (seen >> 1U & 1U) + (seen >> 2U & 1U));
}

//! Cost of all that depends on one run's axis: that of its junctions.
double costAround(const GuidingGraph& graph, const Orientation& orientation, int runId) {
  double cost = 0.0;
  for (const int j : graph.runs[at(runId)].junctions) {
    cost += static_cast<double>(axesAt(graph.junctions[at(j)], orientation) - 1);
  }
  return cost;
}

//! One sweep over the runs that have a choice, in a random order; Metropolis at this temperature.
bool sweep(const GuidingGraph& graph,
           std::vector<int>* free,
           double temperature,
           base::Rng* rng,
           Orientation* orientation) {
  bool changed = false;
  for (std::size_t i = free->size(); i > 1; --i) {
    std::swap((*free)[i - 1], (*free)[rng->below(static_cast<std::uint32_t>(i))]);
  }
  for (const int run : *free) {
    const std::vector<Axis>& axes = graph.runs[at(run)].axes;
    const Axis before = (*orientation)[at(run)];
    const double costBefore = costAround(graph, *orientation, run);
    (*orientation)[at(run)] = axes[0] == before ? axes[1] : axes[0];
    const double delta = costAround(graph, *orientation, run) - costBefore;
    const bool better = delta < -kSame;
    const bool accepted =
        better || (temperature > 0.0 && rng->unit() < base::detExp(-delta / temperature));
    if (!accepted) {
      (*orientation)[at(run)] = before;
    }
    changed = changed || better;
  }
  return changed;
}

//! Simulated annealing from one start (paper 5.1), ended by sweeps that only improve.
void anneal(const GuidingGraph& graph, base::Rng* rng, Orientation* orientation) {
  std::vector<int> free;
  for (std::size_t r = 0; r < graph.runs.size(); ++r) {
    if (graph.runs[r].axes.size() > 1) {
      free.push_back(static_cast<int>(r));
    }
  }
  for (double temperature = kFirstTemperature; temperature > kLastTemperature && !free.empty();
       temperature *= kCooling) {
    sweep(graph, &free, temperature, rng, orientation);
  }
  for (int i = 0; i < kMaxSweeps && sweep(graph, &free, 0.0, rng, orientation); ++i) {
  }
}

}  // namespace

double orientationCost(const GuidingGraph& graph, const Orientation& orientation) {
  double cost = 0.0;
  for (const Junction& junction : graph.junctions) {
    cost += static_cast<double>(axesAt(junction, orientation) - 1);
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
    anneal(graph, rng, &orientation);
    const double cost = orientationCost(graph, orientation);
    if (best.empty() || cost < bestCost) {
      best = orientation;
      bestCost = cost;
    }
  }
  return best;
}

}  // namespace liftarm::guide
