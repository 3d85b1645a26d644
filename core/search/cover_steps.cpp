#include "search/cover_steps.h"

#include <algorithm>
#include <iterator>

#include "base/index.h"

namespace liftarm::search {

namespace {

using base::at;
using layout::Beam;
using layout::Cover;

//! The beams of a run without the arms of bent beams whose other arm has gone: where a symmetry
//! binds runs, that of the image goes with it.
std::vector<Beam> withoutLoneArms(const SearchState& state, int run) {
  std::vector<Beam> rest;
  for (const Beam& beam : state.coverOf(run).beams) {
    const bool bent = beam.mate >= 0 && beam.site < 0;
    const std::vector<Beam> others =
        bent ? layout::armsOf(state.coverOf(beam.mate)) : std::vector<Beam>{};
    const bool whole = std::any_of(
        others.begin(), others.end(), [&](const Beam& other) { return other.mate == run; });
    if (!bent || whole) {
      rest.push_back(beam);
    }
  }
  return rest;
}

//! Arms that the sketch keeps stay.
std::vector<Beam> withoutArms(const std::vector<Beam>& beams, const layout::RunKeep* keep) {
  std::vector<Beam> rest;
  std::copy_if(beams.begin(), beams.end(), std::back_inserter(rest), [&](const Beam& beam) {
    return !beam.isArm() || (keep != nullptr && keep->keeps(beam));
  });
  return rest;
}

//! The beams of a cover without one arm.
Cover withoutArm(Cover cover, const Beam& arm) {
  cover.beams.erase(std::remove(cover.beams.begin(), cover.beams.end(), arm), cover.beams.end());
  return cover;
}

//! Takes a frame off its other runs, which are covered anew. \pre It is off this one.
bool takeFrameOff(SearchState& state, int run, int site, const Manner& manner) {
  std::vector<int> bare;
  Beam bar;
  bar.site = site;
  takeOff(state, run, bar, &bare);
  bool changed = false;
  for (const int other : bare) {
    const Cover& cover = state.coverOf(other);
    const std::vector<Beam> kept = layout::armsOf(cover);
    changed = coverRun(state, other, cover.axis, manner, kept) || changed;
  }
  return changed;
}

}  // namespace

bool coverRun(SearchState& state,
              int run,
              lattice::Axis axis,
              const Manner& manner,
              const std::vector<Beam>& fixed) {
  return state.cover({run, axis, manner, fixed});
}

bool recover(SearchState& state, int run, const Manner& manner, double turning) {
  base::Rng& rng = state.rng();
  const std::vector<lattice::Axis>& axes = state.graph().runs[at(run)].axes;
  lattice::Axis axis = state.coverOf(run).axis;
  const std::vector<Beam> arms = layout::armsOf(state.coverOf(run));
  if (!arms.empty() && rng.unit() < kTuning.moves.straighten) {
    return straighten(state, run, manner);
  }
  if (state.options().parts.turns && arms.empty() && axes.size() > 1 && rng.unit() < turning) {
    axis = axes[0] == axis ? axes[1] : axes[0];
  }
  return coverRun(state, run, axis, manner, arms);
}

bool straighten(SearchState& state, int run, const Manner& manner) {
  bool changed = false;
  const layout::RunKeep* keep = state.problem().keepOf(run);
  const std::vector<Beam> arms = layout::armsOf(state.coverOf(run));
  Cover bare = state.coverOf(run);
  bare.beams = withoutArms(bare.beams, keep);
  state.place(run, bare);
  for (const Beam& arm : arms) {
    if (keep != nullptr && keep->keeps(arm)) {
      continue;
    }
    if (arm.site >= 0) {
      changed = takeFrameOff(state, run, arm.site, manner) || changed;
      continue;
    }
    const Cover mate{state.coverOf(arm.mate).axis, withoutLoneArms(state, arm.mate)};
    const std::vector<Beam> kept = layout::armsOf(mate);
    state.place(arm.mate, mate);
    changed = coverRun(state, arm.mate, mate.axis, manner, kept) || changed;
  }
  return coverRun(state, run, state.coverOf(run).axis, manner, {}) || changed;
}

void takeOff(SearchState& state, int run, const Beam& arm, std::vector<int>* bare) {
  const auto strip = [&](int other, const auto& belongs) {
    const Cover cover = state.coverOf(other);
    const auto found = std::find_if(cover.beams.begin(), cover.beams.end(), belongs);
    if (found != cover.beams.end()) {
      state.layout().setCover(other, withoutArm(cover, *found));
    }
    if (other != run && !base::contains(*bare, other)) {
      bare->push_back(other);
    }
  };
  if (arm.site < 0) {
    strip(arm.mate, [&](const Beam& beam) { return beam.mate == run; });
    strip(run, [&](const Beam& beam) { return beam == arm; });
    return;
  }
  for (const layout::SiteArm& other : state.problem().sites[at(arm.site)].arms) {
    strip(other.run, [&](const Beam& beam) { return beam.site == arm.site; });
  }
}

}  // namespace liftarm::search
