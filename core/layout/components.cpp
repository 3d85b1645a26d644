#include "layout/components.h"

#include <algorithm>
#include <numeric>

#include "base/index.h"

namespace liftarm::layout {

namespace {

using base::at;

int rootOf(std::vector<int>* parents, int i) {
  while ((*parents)[at(i)] != i) {
    (*parents)[at(i)] = (*parents)[at((*parents)[at(i)])];
    i = (*parents)[at(i)];
  }
  return i;
}

}  // namespace

Components findComponents(const guide::GuidingGraph& graph, const std::vector<Cover>& covers) {
  std::vector<int> parents(graph.runs.size());
  std::iota(parents.begin(), parents.end(), 0);
  for (const guide::Junction& junction : graph.junctions) {
    for (const guide::Incidence& a : junction.incident) {
      for (const guide::Incidence& b : junction.incident) {
        // Runs that meet and share a hole axis lie in the plane across it.
        if (covers[at(a.run)].axis == covers[at(b.run)].axis) {
          parents[at(rootOf(&parents, a.run))] = rootOf(&parents, b.run);
        }
      }
    }
  }
  Components components;
  components.ofRun.assign(graph.runs.size(), -1);
  std::vector<int> numbers(graph.runs.size(), -1);
  for (std::size_t r = 0; r < graph.runs.size(); ++r) {
    const int root = rootOf(&parents, static_cast<int>(r));
    if (numbers[at(root)] < 0) {
      numbers[at(root)] = components.count++;
    }
    components.ofRun[r] = numbers[at(root)];
  }
  return components;
}

int largestLayerRange(const Components& components, const std::vector<Cover>& covers) {
  std::vector<int> low(at(components.count), guide::kMaxLayer + 1);
  std::vector<int> high(at(components.count), -guide::kMaxLayer - 1);
  for (std::size_t r = 0; r < covers.size(); ++r) {
    const std::size_t c = at(components.ofRun[r]);
    for (const Beam& beam : covers[r].beams) {
      low[c] = std::min(low[c], beam.layer);
      high[c] = std::max(high[c], beam.layer);
    }
  }
  int range = 0;
  for (std::size_t c = 0; c < low.size(); ++c) {
    range = std::max(range, high[c] - low[c]);
  }
  return range;
}

}  // namespace liftarm::layout
