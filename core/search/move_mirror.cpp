#include "base/index.h"
#include "search/cover_steps.h"
#include "search/moves.h"

namespace liftarm::search {

namespace {

using base::at;

//! Covers those runs anew that meet this one in a stack with a fault; false when there is none.
bool recoverCrossing(SearchState& state, int run, const Manner& manner) {
  const guide::GuidingGraph& graph = state.graph();
  bool any = false;
  for (const int junction : graph.runs[at(run)].junctions) {
    if (state.layout().stackViolationsAt(junction) == 0) {
      continue;
    }
    for (const guide::Incidence& incidence : graph.junctions[at(junction)].incident) {
      const layout::Cover& cover = state.coverOf(incidence.run);
      if (incidence.run != run && !layout::hasArms(cover)) {
        any = coverRun(state, incidence.run, cover.axis, manner, {}) || any;
      }
    }
  }
  return any;
}

}  // namespace

bool mirrorLayers(SearchState& state, const MoveContext& context) {
  const int run = context.pick.run;
  layout::Cover cover = state.coverOf(run);
  if (state.graph().runs[at(run)].exact || layout::hasArms(cover) || cover.axle.used() ||
      state.problem().keepOf(run) != nullptr) {
    return false;
  }
  const OrbitCovers& orbits = state.covering().orbits();
  const guide::SelfBinding binding =
      orbits.active() ? orbits.orbits().binding(run, cover.axis) : guide::SelfBinding{};
  if (binding.pinned || binding.sign < 0) {
    return false;
  }
  const int sum = state.rng().below(2) == 0 ? 1 : -1;
  const int farthest = guide::kMaxLayer - orbits.farthestLift(run, cover.axis);
  for (layout::Beam& beam : cover.beams) {
    beam.layer = sum - beam.layer;
    if (beam.layer > farthest || beam.layer < -farthest) {
      return false;
    }
  }
  state.place(run, cover);
  Manner manner = context.manner;
  manner.noise = kTuning.moves.mirrorNoise * manner.noise;
  if (recoverCrossing(state, run, manner)) {
    recoverCrossing(state, run, manner);
  }
  return true;
}

}  // namespace liftarm::search
