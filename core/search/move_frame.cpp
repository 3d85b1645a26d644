#include <algorithm>

#include "base/index.h"
#include "search/arm_costs.h"
#include "search/cover_steps.h"
#include "search/moves.h"

namespace liftarm::search {

namespace {

using base::at;
using layout::Beam;
using layout::Cover;

//! Whether no symmetry binds a site's runs, nothing that is kept there stands in the way, and all
//! have its hole axis or may turn to it.
bool mayLieAt(const SearchState& state, const layout::FrameSite& site, int layer) {
  const Covering& covering = state.covering();
  return std::all_of(site.arms.begin(), site.arms.end(), [&](const layout::SiteArm& arm) {
    Beam bar = arm.beam;
    bar.layer = layer;
    return layout::mayLie(state.problem(), arm.run, bar) && !covering.orbits().binds(arm.run) &&
           !covering.axles().mustHave(arm.run) &&
           (state.options().parts.turns || state.coverOf(arm.run).axis == site.axis);
  });
}

//! The runs of a site, and after them those that lose a bent beam or a frame which is in its way.
std::vector<int> makeRoom(SearchState& state, const layout::FrameSite& site) {
  std::vector<int> runs;
  for (const layout::SiteArm& arm : site.arms) {
    runs.push_back(arm.run);
  }
  for (const layout::SiteArm& arm : site.arms) {
    const Cover cover = state.coverOf(arm.run);
    for (const Beam& other : layout::armsOf(cover)) {
      if (cover.axis != site.axis || meetsAny(arm.beam, {other})) {
        takeOff(state, arm.run, other, &runs);
      }
    }
  }
  return runs;
}

//! Lets some of the runs follow that cross those whose layers have changed along their length.
void letFollow(SearchState& state, const std::vector<int>& covered, const Manner& manner) {
  base::Rng& rng = state.rng();
  const std::uint32_t followers = rng.below(kTuning.moves.followers);
  for (std::uint32_t i = 0; i < followers; ++i) {
    const int run = covered[rng.below(static_cast<std::uint32_t>(covered.size()))];
    const std::optional<int> other = pickPartner(state, run);
    if (other && std::find(covered.begin(), covered.end(), *other) == covered.end()) {
      recover(state, *other, manner);
    }
  }
}

}  // namespace

bool layFrame(SearchState& state, const MoveContext& context) {
  const std::vector<int>& places = state.frames().useful();
  const int place = places[state.rng().below(static_cast<std::uint32_t>(places.size()))];
  const layout::FrameSite& site = state.problem().sites[at(place)];
  const int layer = site.exact ? 0 : static_cast<int>(state.rng().below(3)) - 1;
  if (!mayLieAt(state, site, layer)) {
    return false;
  }
  const std::vector<int> covered = makeRoom(state, site);
  std::vector<std::vector<Beam>> fixed;
  std::vector<lattice::Axis> axes;
  for (std::size_t i = 0; i < covered.size(); ++i) {
    const Cover cover = state.coverOf(covered[i]);
    fixed.push_back(layout::armsOf(cover));
    axes.push_back(i < site.arms.size() ? site.axis : cover.axis);
    if (i < site.arms.size()) {
      fixed.back().push_back(site.arms[i].beam);
      fixed.back().back().layer = layer;
    }
    state.layout().setCover(covered[i], {axes.back(), {}});
  }
  for (std::size_t i = 0; i < covered.size(); ++i) {
    if (!coverRun(state, covered[i], axes[i], context.manner, fixed[i])) {
      return false;
    }
  }
  letFollow(state, covered, context.manner);
  return true;
}

}  // namespace liftarm::search
