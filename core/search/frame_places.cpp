#include "search/frame_places.h"

#include <algorithm>

#include "base/index.h"
#include "guide/beam_bound.h"
#include "search/arm_costs.h"
#include "search/tuning.h"

namespace liftarm::search {

using base::at;

FramePlaces::FramePlaces(const layout::LayoutProblem& problem, const AnnealingOptions& options) {
  const guide::GuidingGraph& graph = problem.graph;
  const std::vector<int>& allowed = options.frames;
  for (std::size_t s = 0; s < problem.sites.size() && options.parts.frames; ++s) {
    const layout::FrameSite& site = problem.sites[s];
    double saved = -1.0;
    for (const layout::SiteArm& arm : site.arms) {
      const guide::GuideRun& run = graph.runs[at(arm.run)];
      saved += static_cast<double>(guide::fewestBeams(graph, run)) -
               beamsBeside(arm.beam, run.edgeCount());
    }
    if (saved >= kTuning.moves.leastFrameGain &&
        std::find(allowed.begin(), allowed.end(), site.frame) != allowed.end()) {
      useful_.push_back(static_cast<int>(s));
    }
  }
}

void FramePlaces::withdraw(layout::Layout* layout) {
  if (!across_) {
    useful_.clear();
  }
  across_ = false;
  layout->setAcross(false);
}

bool hasFrame(const LayoutSnapshot& layout) {
  return std::any_of(layout.covers.begin(), layout.covers.end(), [](const layout::Cover& cover) {
    return std::any_of(cover.beams.begin(), cover.beams.end(), [](const layout::Beam& beam) {
      return beam.site >= 0;
    });
  });
}

}  // namespace liftarm::search
