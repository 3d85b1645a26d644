#include "search/run_picker.h"

#include <span>

#include "base/index.h"
#include "guide/beam_bound.h"
#include "search/tuning.h"

namespace liftarm::search {

namespace {

using base::at;

constexpr const PickTuning& kPicks = kTuning.picks;

//! One of a list, at random. \pre It is not empty.
int oneOf(std::span<const int> list, base::Rng* rng) {
  return list[rng->below(static_cast<std::uint32_t>(list.size()))];
}

int runOf(const std::vector<guide::Incidence>& incident, base::Rng* rng) {
  return incident[rng->below(static_cast<std::uint32_t>(incident.size()))].run;
}

}  // namespace

std::optional<int> pickPartner(SearchState& state, int run) {
  const std::vector<int>& met = state.graph().runs[at(run)].junctions;
  if (met.empty()) {
    return std::nullopt;
  }
  const guide::Junction& junction = state.graph().junctions[at(oneOf(met, &state.rng()))];
  const int other = runOf(junction.incident, &state.rng());
  return other == run ? std::nullopt : std::optional(other);
}

RunPicker::RunPicker(const guide::GuidingGraph& graph) {
  for (const guide::GuideRun& run : graph.runs) {
    fewestBeams_.push_back(guide::fewestBeams(graph, run));
  }
}

Pick RunPicker::pick(SearchState& state, const MoveHabits& habits) {
  base::Rng& rng = state.rng();
  const SearchParts& parts = state.options().parts;
  const bool violated = state.layout().tallies().violations() > 0;
  if (!habits.loose.empty() && !violated && rng.unit() < kPicks.loose) {
    return {oneOf(habits.loose, &rng)};
  }
  if (!habits.focus.empty() && (!violated || rng.unit() >= kPicks.violated)) {
    return {oneOf(habits.focus, &rng)};
  }
  if (parts.focus && violated && rng.unit() < kPicks.violated) {
    return violatedPlace(state);
  }
  if (parts.costly && rng.unit() < kPicks.costly) {
    if (const std::optional<int> costly = costlyRun(state)) {
      return {*costly};
    }
  }
  return {anyRun(state)};
}

int RunPicker::anyRun(SearchState& state) {
  return static_cast<int>(state.rng().below(static_cast<std::uint32_t>(state.graph().runs.size())));
}

//! A junction or a run with violations, and then a run there.
Pick RunPicker::violatedPlace(SearchState& state) {
  base::Rng& rng = state.rng();
  const layout::Layout& layout = state.layout();
  places_.clear();
  for (std::size_t j = 0; j < state.graph().junctions.size(); ++j) {
    if (layout.junction(static_cast<int>(j)).violations() > 0) {
      places_.push_back(static_cast<int>(j));
    }
  }
  const std::size_t junctions = places_.size();
  for (std::size_t r = 0; r < fewestBeams_.size(); ++r) {
    const layout::RunState& run = layout.run(static_cast<int>(r));
    if (run.collisions + run.forbidden > 0) {
      places_.push_back(static_cast<int>(r));
    }
  }
  if (places_.empty()) {
    return {anyRun(state)};
  }
  const std::size_t pick = rng.below(static_cast<std::uint32_t>(places_.size()));
  const int place = places_[pick];
  if (pick >= junctions) {
    return {place};
  }
  const guide::Junction& junction = state.graph().junctions[at(place)];
  const int run =
      rng.unit() < kPicks.near ? oneOf(junction.nearRuns, &rng) : runOf(junction.incident, &rng);
  return {run, place};
}

//! A run with more beams than it needs, or one that meets it.
std::optional<int> RunPicker::costlyRun(SearchState& state) {
  places_.clear();
  for (std::size_t r = 0; r < fewestBeams_.size(); ++r) {
    const int run = static_cast<int>(r);
    if (static_cast<int>(state.coverOf(run).beams.size()) > fewestBeams_[r]) {
      places_.push_back(run);
    }
  }
  if (places_.empty()) {
    return std::nullopt;
  }
  const int run = oneOf(places_, &state.rng());
  return state.rng().below(2) == 0 ? pickPartner(state, run).value_or(run) : run;
}

}  // namespace liftarm::search
