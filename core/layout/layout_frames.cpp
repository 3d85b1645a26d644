#include <algorithm>

#include "base/index.h"
#include "layout/layout.h"

// What frames are to a junction: bodies with holes on two axes, several of whose bars may be near.

namespace liftarm::layout {

namespace {

using base::at;
using lattice::Axis;
using lattice::Cell;

}  // namespace

//! Whether a frame lies at a junction: then it alone may join all beams there.
bool Layout::hasFrameAt(int junction) const {
  if (problem_->sites.empty()) {
    return false;
  }
  const std::vector<guide::Incidence>& incident = problem_->graph.junctions[at(junction)].incident;
  return std::any_of(incident.begin(), incident.end(), [&](const guide::Incidence& incidence) {
    const std::vector<Beam>& beams = runs_[at(incidence.run)].cover.beams;
    return std::any_of(beams.begin(), beams.end(), [&](const Beam& beam) {
      return beam.site >= 0 && beam.reaches(incidence.index);
    });
  });
}

//! Enters a frame's bar into the local problem. Any of the frame's holes will do where one of its
//! bars is to be joined; elsewhere only those along its normal, so that no mechanism goes into a
//! frame along two axes. Where bars meet, the one on the lowest run brings the hole.
void Layout::fillFrame(const RunView& view,
                       const Beam& bar,
                       const InlinePins& before,
                       const InlinePins& after) {
  const guide::GuideRun& run = problem_->graph.runs[at(view.run)];
  const Axis axis = runs_[at(view.run)].cover.axis;
  const FrameSite& site = problem_->sites[at(bar.site)];
  int terminal = -1;
  for (std::size_t t = 0; t < localTerminals_.size() && terminal < 0; ++t) {
    const auto [other, beam] = localTerminals_[t];
    const bool same = beam >= 0 && runs_[at(other)].cover.beams[at(beam)].site == bar.site;
    terminal = same ? static_cast<int>(t) : -1;
  }
  local_.frames |= terminal < 0 ? 0U : 1U << static_cast<unsigned>(terminal);
  const bool foreign = run.piece != localPiece_;
  const Cell layer = scaled(bar.layer, unitCell(axis));
  for (int i = bar.start; i <= bar.last(); ++i) {
    const Cell cell = view.base + scaled(i, view.step) + layer;
    const bool brought = std::any_of(site.arms.begin(), site.arms.end(), [&](const SiteArm& arm) {
      return arm.run < view.run && cornerIndex(problem_->graph, view.run, arm.run) == i &&
             arm.beam.reaches(cornerIndex(problem_->graph, arm.run, view.run));
    });
    // Sites are chosen where every view of their bars is aligned.
    if (!view.aligned || !inBox(cell) || brought) {
      continue;
    }
    if ((!across_ || terminal < 0) && !bar.hasHoleAt(i)) {
      local_.block(boxIndex(cell));
    } else {
      local_.addHole({cell,
                      bar.hasHoleAt(i) ? axis : axisAcross(run, axis),
                      terminal,
                      foreign || before.has(i) || after.has(i)});
    }
  }
}

}  // namespace liftarm::layout
