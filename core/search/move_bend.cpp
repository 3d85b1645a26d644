#include <algorithm>
#include <limits>

#include "base/index.h"
#include "search/arm_costs.h"
#include "search/cover_steps.h"
#include "search/moves.h"

namespace liftarm::search {

namespace {

using base::at;
using layout::Beam;
using layout::Cover;

//! The hole axis that two runs may have in common: theirs, where it is the same, else one that both
//! may turn to. None where a joint lets them turn against each other.
std::optional<lattice::Axis> bendAxis(const SearchState& state, int run, int mate) {
  const guide::GuidingGraph& graph = state.graph();
  const Cover& mine = state.coverOf(run);
  const Cover& theirs = state.coverOf(mate);
  const int junction = layout::commonJunction(graph, run, mate);
  if (junction < 0 || mine.axle.used() || theirs.axle.used() ||
      graph.junctions[at(junction)].joint >= 0) {
    return std::nullopt;
  }
  if (mine.axis == theirs.axis) {
    return mine.axis;
  }
  const std::vector<lattice::Axis>& others = graph.runs[at(mate)].axes;
  for (const lattice::Axis axis : graph.runs[at(run)].axes) {
    const bool common = std::find(others.begin(), others.end(), axis) != others.end();
    if (state.options().parts.turns && common && (axis == mine.axis || !layout::hasArms(mine)) &&
        (axis == theirs.axis || !layout::hasArms(theirs))) {
      return axis;
    }
  }
  return std::nullopt;
}

//! One of the bent beams that fit beside the arms that two runs have already: mostly one of those
//! that leave the fewest beams beside it.
std::optional<layout::Bend> pickBend(
    SearchState& state, int run, int mate, lattice::Axis axis, int layer) {
  const guide::GuidingGraph& graph = state.graph();
  const std::vector<Beam> fixed = layout::armsOf(state.coverOf(run));
  const std::vector<Beam> mateFixed = layout::armsOf(state.coverOf(mate));
  std::vector<layout::Bend> bends;
  for (const int form : state.options().bends) {
    layout::addBends(graph, form, run, mate, layer, &bends);
  }
  const int edges = graph.runs[at(run)].edgeCount();
  const int mateEdges = graph.runs[at(mate)].edgeCount();
  const OrbitCovers& orbits = state.covering().orbits();
  const bool cheapest = state.rng().unit() < kTuning.moves.cheapBend;
  double least = std::numeric_limits<double>::max();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < bends.size(); ++i) {
    const layout::Bend bend = bends[i];
    const double rest =
        cheapest ? beamsBeside(bend.arm, edges) + beamsBeside(bend.mateArm, mateEdges) : 0.0;
    if (rest > least || meetsAny(bend.arm, fixed) || meetsAny(bend.mateArm, mateFixed) ||
        !orbits.hasRoom(run, axis, bend.arm) || !orbits.hasRoom(mate, axis, bend.mateArm) ||
        !layout::mayLie(state.problem(), run, bend.arm) ||
        !layout::mayLie(state.problem(), mate, bend.mateArm)) {
      continue;
    }
    kept = rest < least ? 0 : kept;
    least = rest;
    bends[kept++] = bend;
  }
  if (kept == 0) {
    return std::nullopt;
  }
  return bends[state.rng().below(static_cast<std::uint32_t>(kept))];
}

//! Lets some of the runs follow that cross two whose layers have changed along their length.
void letFollow(SearchState& state, int run, int mate, const Manner& manner) {
  const std::uint32_t followers = state.rng().below(kTuning.moves.followers);
  for (std::uint32_t i = 0; i < followers; ++i) {
    const std::optional<int> other = pickPartner(state, i % 2 == 0 ? run : mate);
    if (other && *other != run && *other != mate) {
      recover(state, *other, manner);
    }
  }
}

}  // namespace

bool layBend(SearchState& state, const MoveContext& context) {
  const int run = context.pick.run;
  const std::optional<int> partner = pickPartner(state, run);
  const auto common = partner ? bendAxis(state, run, *partner) : std::nullopt;
  if (!common) {
    return false;
  }
  const int mate = *partner;
  const lattice::Axis axis = *common;
  const int layer = static_cast<int>(state.rng().below(3)) - 1;
  if (!state.covering().orbits().mayBend(run, mate, axis, layer)) {
    return false;
  }
  const std::optional<layout::Bend> bend = pickBend(state, run, mate, axis, layer);
  if (!bend) {
    return false;
  }
  std::vector<Beam> fixed = layout::armsOf(state.coverOf(run));
  std::vector<Beam> mateFixed = layout::armsOf(state.coverOf(mate));
  fixed.push_back(bend->arm);
  mateFixed.push_back(bend->mateArm);
  state.place(run, {axis, {}});
  state.place(mate, {axis, {}});
  if (!coverRun(state, run, axis, context.manner, fixed) ||
      !coverRun(state, mate, axis, context.manner, mateFixed)) {
    return false;
  }
  letFollow(state, run, mate, context.manner);
  return true;
}

}  // namespace liftarm::search
