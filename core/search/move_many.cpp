#include <algorithm>
#include <utility>

#include "base/index.h"
#include "search/cover_steps.h"
#include "search/moves.h"

namespace liftarm::search {

namespace {

using base::at;

//! A run that may stand in this one's way: one that it meets, one near the violated junction, or
//! one that passes near.
std::optional<int> pickInTheWay(SearchState& state, const Pick& pick) {
  base::Rng& rng = state.rng();
  const auto oneOf = [&](const std::vector<int>& list) {
    return list[rng.below(static_cast<std::uint32_t>(list.size()))];
  };
  const std::optional<int> partner = pickPartner(state, pick.run);
  if (pick.junction && rng.below(2) == 0) {
    return oneOf(state.graph().junctions[at(*pick.junction)].nearRuns);
  }
  const std::vector<int>& near = state.graph().runs[at(pick.run)].near;
  return partner || near.empty() ? partner : oneOf(near);
}

//! The run and some in its way, of each orbit the first.
std::vector<int> pickMany(SearchState& state, const Pick& pick) {
  const OrbitCovers& orbits = state.covering().orbits();
  const auto firstOf = [&](int run) {
    return orbits.binds(run) ? orbits.orbits().representative(run) : run;
  };
  std::vector<int> picked{firstOf(pick.run)};
  const std::uint32_t wanted = 1 + state.rng().below(kTuning.moves.mostMany);
  for (std::uint32_t i = 0; i < wanted; ++i) {
    const std::optional<int> found = pickInTheWay(state, pick);
    if (!found) {
      continue;
    }
    const int other = firstOf(*found);
    if (!layout::hasArms(state.coverOf(other)) &&
        std::find(picked.begin(), picked.end(), other) == picked.end()) {
      picked.push_back(other);
    }
  }
  return picked;
}

}  // namespace

bool clearMany(SearchState& state, const MoveContext& context) {
  if (layout::hasArms(state.coverOf(context.pick.run))) {
    return straighten(state, context.pick.run, context.manner);
  }
  std::vector<int> cleared = pickMany(state, context.pick);
  std::vector<layout::Cover> before;
  for (const int run : cleared) {
    before.push_back(state.coverOf(run));
    state.place(run, layout::bareCover(state.problem(), run, state.coverOf(run).axis));
  }
  for (std::size_t i = cleared.size(); i > 1; --i) {
    const std::size_t j = state.rng().below(static_cast<std::uint32_t>(i));
    std::swap(cleared[i - 1], cleared[j]);
    std::swap(before[i - 1], before[j]);
  }
  for (std::size_t i = 0; i < cleared.size(); ++i) {
    if (!recover(state, cleared[i], context.manner, kTuning.moves.turnMany)) {
      state.place(cleared[i], before[i]);
    }
  }
  return true;
}

}  // namespace liftarm::search
