#include "search/phase_earlier.h"

#include <algorithm>
#include <optional>

#include "base/index.h"
#include "guide/beam_bound.h"
#include "search/phase_axles.h"
#include "search/phase_first_layout.h"
#include "search/phase_stiffen.h"
#include "search/tuning.h"

namespace liftarm::search {

using base::at;

Next FromEarlier::begin() {
  const AnnealingOptions& options = state().options();
  if (options.from != nullptr) {
    state().restore(*options.from);
    state().accept();
    state().keepBest();
    return RoundPlan{roundLength(options, kTuning.rounds.firstShare, state().graph().runs.size()),
                     std::min(kTuning.rounds.earlierTemperature, options.startTemperature)};
  }
  // Orbits and stiffening move runs all over the sketch: what is asked of those is asked afresh.
  if (options.earlier.empty() || state().covering().orbits().active()) {
    return goTo<FirstLayout>();
  }
  KeptRuns kept =
      keepRuns(state().graph(),
               options.earlier,
               {options.lengths, options.bends, options.frames, state().problem().sites});
  dropUnwanted(state().problem(), &kept);
  if (2 * kept.kept < static_cast<int>(state().graph().runs.size())) {
    return goTo<FirstLayout>();
  }
  lay(kept);
  touched_ = kept.touched;
  state().setGrown();
  state().keepBest();
  if (touched_.empty() && keepsUp()) {
    return state().withdrawFrames() ? Next{StartOver{}} : Next{EndOfSearch{}};
  }
  return RoundPlan{roundLength(options, kTuning.rounds.firstShare, touched_.size()),
                   std::min(kTuning.rounds.earlierTemperature, options.startTemperature)};
}

//! Lays what the earlier layout had, and covers what is new.
void FromEarlier::lay(const KeptRuns& kept) {
  layout::Layout& layout = state().layout();
  const guide::GuidingGraph& graph = state().graph();
  const std::vector<layout::FrameSite>& sites = state().problem().sites;
  std::vector<int> fresh;
  for (int r = 0; r < static_cast<int>(graph.runs.size()); ++r) {
    const guide::GuideRun& run = graph.runs[at(r)];
    const std::optional<layout::Cover>& cover = kept.covers[at(r)];
    layout.setCover(r, cover.value_or(layout::bareCover(state().problem(), r, run.axes.front())));
    if (!cover) {
      fresh.push_back(r);
      mostBeams_ += guide::fewestBeams(graph, run) + 1;
      continue;
    }
    for (const layout::Beam& beam : cover->beams) {
      const bool counted = beam.site >= 0 && sites[at(beam.site)].arms.front().run != r;
      mostBeams_ += counted ? 0 : layout::partsOfBeam(beam.holes);
    }
  }
  layout.settleAll();
  layout.keep();
  for (int pass = 0; pass < kTuning.first.passes; ++pass) {
    for (const int run : fresh) {
      layBestAxis(run);
    }
  }
  state().accept();
}

//! Covers a run with the hole axis that suits its neighbours best.
void FromEarlier::layBestAxis(int run) {
  layout::Layout& layout = state().layout();
  Covering& covering = state().covering();
  if (covering.axles().mustHave(run)) {
    covering.axles().lay(&layout, run);
    layout.settle();
    layout.keep();
    return;
  }
  std::optional<layout::Cover> best;
  double least = 0.0;
  for (const lattice::Axis axis : state().graph().runs[at(run)].axes) {
    std::optional<layout::Cover> cover = covering.propose({run, axis}, layout, &state().rng());
    if (!cover) {
      continue;
    }
    layout.setCover(run, *cover);
    layout.settle();
    const double now = state().measure();
    layout.revert();
    if (!best || now < least) {
      least = now;
      best = std::move(cover);
    }
  }
  if (best) {
    layout.setCover(run, std::move(*best));
    layout.settle();
    layout.keep();
  }
}

//! Whether what came of the earlier layout may stand: whole, and hardly more beams than before.
bool FromEarlier::keepsUp() const {
  return state().hasWhole() && state().best().tallies.beams <= mostBeams_;
}

Next FromEarlier::endRound() {
  if (state().options().from != nullptr) {
    return state().options().freedoms ? goTo<Stiffening>() : goTo<AxleTrials>();
  }
  if (!keepsUp() || state().withdrawFrames()) {
    return StartOver{};
  }
  return goTo<AxleTrials>();
}

}  // namespace liftarm::search
