#include "search/phase_first_layout.h"

#include <algorithm>

#include "base/index.h"
#include "guide/layer_field.h"
#include "guide/orientation.h"
#include "search/phase_rounds.h"
#include "search/tuning.h"

namespace liftarm::search {

namespace {

using base::at;

guide::Orientation orientationOf(SearchState& state, int starts) {
  const OrbitCovers& orbits = state.covering().orbits();
  guide::Orientation orientation =
      orbits.active()
          ? guide::estimateOrientation(state.graph(), orbits.orbits(), starts, &state.rng())
          : guide::estimateOrientation(state.graph(), starts, &state.rng());
  state.covering().axles().turn(&orientation);
  return orientation;
}

//! Covers a run and its images for the first time; frees them when no cover suits them all.
bool layBound(SearchState& state, const CoverRequest& request) {
  for (int i = 0; i < kTuning.first.tries; ++i) {
    if (state.cover(request)) {
      return true;
    }
  }
  state.covering().orbits().release(request.run);
  return false;
}

void coverFirst(SearchState& state, const CoverRequest& request) {
  Covering& covering = state.covering();
  const OrbitCovers& orbits = covering.orbits();
  const int run = request.run;
  if (orbits.binds(run) && orbits.orbits().representative(run) != run) {
    return;  // covered with the first of its images
  }
  if (covering.axles().mustHave(run)) {
    covering.axles().lay(&state.layout(), run);  // laid anew when all are there
    return;
  }
  if (orbits.binds(run) && layBound(state, request)) {
    return;
  }
  if (auto cover = covering.propose(request, state.layout(), &state.rng())) {
    state.layout().setCover(run, std::move(*cover));
  }
}

//! Hole axes from stage one, then every run covered once.
void layFirst(SearchState& state, int starts) {
  layout::Layout& layout = state.layout();
  const auto runs = static_cast<int>(state.graph().runs.size());
  const guide::Orientation orientation = orientationOf(state, starts);
  // The first covers see hole axes but no beams; the later ones see what was laid before them.
  for (int r = 0; r < runs; ++r) {
    layout.setCover(r, layout::bareCover(state.problem(), r, orientation[at(r)]));
  }
  const guide::LayerField field = guide::makeLayerField(state.graph(), orientation, &state.rng());
  for (int r = 0; r < runs; ++r) {
    CoverRequest request{r, orientation[at(r)], {kTuning.first.noise, guide::kMaxLayer}};
    if (state.options().parts.walls) {
      request.preferred = field[at(r)];
    }
    coverFirst(state, request);
  }
  state.covering().axles().follow(&layout);
  layout.settleAll();
  layout.keep();
  state.accept();
}

}  // namespace

Next FirstLayout::begin() {
  state().covering().releaseAxleRuns();
  // Fewer starts for very large sketches, so that the first layout does not keep a person waiting.
  const auto runs = static_cast<int>(state().graph().runs.size());
  const int affordable = kTuning.first.budget / std::max(1, runs);
  layFirst(state(), std::max(1, std::min(state().options().starts, affordable)));
  state().keepBest();
  return goTo<Rounds>();
}

Next FirstLayout::endRound() {
  return goTo<Rounds>();
}

void layAgain(SearchState& state) {
  state.forgetGrudges();
  layFirst(state, kTuning.first.laterStarts);
}

}  // namespace liftarm::search
