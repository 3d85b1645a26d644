#include "search/axle_runs.h"

#include <algorithm>

#include "base/index.h"
#include "layout/axle_collisions.h"
#include "search/axle_sites.h"

namespace liftarm::search {

using base::at;

AxleRuns::AxleRuns(const layout::LayoutProblem& problem, std::vector<int> axles)
    : problem_(&problem), axles_(std::move(axles)) {
  const auto runs = static_cast<int>(problem.graph.runs.size());
  must_.assign(at(runs), 0);
  if (axles_.empty()) {
    return;
  }
  int longest = 0;
  for (const int axle : axles_) {
    longest = std::max(longest, layout::axleParts()[at(axle)].length);
  }
  for (int run = 0; run < runs; ++run) {
    if (mayHaveAxle(problem.graph, run, longest)) {
      runs_.push_back(run);
      must_[at(run)] = needsAxle(problem.graph, run) ? 1 : 0;
    }
  }
}

void AxleRuns::turn(guide::Orientation* orientation) const {
  const guide::GuidingGraph& graph = problem_->graph;
  for (const int run : runs_) {
    if (mustHave(run)) {
      for (const int met : runsMet(graph, run)) {
        (*orientation)[at(met)] = layout::alongAxisOf(graph.runs[at(run)]).axis;
      }
    }
  }
}

bool AxleRuns::lay(layout::Layout* layout, int run) const {
  const layout::Axle axle = layout::layAxle(layout->axleSite(run), axles_);
  const layout::Cover& before = layout->run(run).cover;
  const layout::Cover cover{before.axis, {}, axle};
  if (!axle.used() || cover == before) {
    return false;
  }
  layout->setCover(run, cover);
  return true;
}

void AxleRuns::follow(layout::Layout* layout) const {
  if (layout->tallies().axles == 0) {
    return;
  }
  for (const int run : runs_) {
    if (layout->run(run).cover.axle.used()) {
      lay(layout, run);
    }
  }
}

}  // namespace liftarm::search
