#include <algorithm>

#include "search/annealer.h"
#include "search/arm_costs.h"

namespace liftarm::search {

namespace {

constexpr double kPickCheapBend = 0.75;  // of these: those that leave the fewest beams beside it
constexpr std::uint32_t kMostFollowers = 7;
constexpr double kNone = 1e300;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

//! The beams of a cover without the arm whose other one is on `mate`; -2 takes out every arm.
std::vector<layout::Beam> withoutMates(const std::vector<layout::Beam>& beams, int mate) {
  std::vector<layout::Beam> rest;
  for (const layout::Beam& beam : beams) {
    if (!beam.isArm() || (mate != -2 && beam.mate != mate)) {
      rest.push_back(beam);
    }
  }
  return rest;
}

}  // namespace

//! Takes the bent beams and frames of a run out: it and the runs of their other arms are covered
//! anew.
bool Annealer::straighten(int run, double noise) {
  bool changed = false;
  const std::vector<layout::Beam> arms = layout::armsOf(layout_.run(run).cover);
  layout::Cover bare = layout_.run(run).cover;
  bare.beams = withoutMates(bare.beams, -2);
  place(run, bare);
  for (const layout::Beam& arm : arms) {
    if (arm.site >= 0) {
      changed = takeFrameOff(run, arm.site, noise) || changed;
      continue;
    }
    const layout::Cover& cover = layout_.run(arm.mate).cover;
    layout::Cover mate{cover.axis, withoutMates(cover.beams, run)};
    const std::vector<layout::Beam> kept = layout::armsOf(mate);
    place(arm.mate, mate);
    changed = coverRun(arm.mate, mate.axis, noise, kept) || changed;
  }
  return coverRun(run, layout_.run(run).cover.axis, noise, {}) || changed;
}

//! The hole axis that two runs may have in common: theirs, where it is the same, else one that both
//! may turn to. None where a joint lets them turn against each other.
std::optional<lattice::Axis> Annealer::bendAxis(int run, int mate) const {
  const guide::GuidingGraph& graph = problem_->graph;
  const int junction = layout::commonJunction(graph, run, mate);
  if (junction < 0 || layout_.run(run).cover.axle.used() || layout_.run(mate).cover.axle.used() ||
      graph.junctions[at(junction)].joint >= 0) {
    return std::nullopt;
  }
  const layout::Cover& mine = layout_.run(run).cover;
  const layout::Cover& theirs = layout_.run(mate).cover;
  if (mine.axis == theirs.axis) {
    return mine.axis;
  }
  for (const lattice::Axis axis : graph.runs[at(run)].axes) {
    const std::vector<lattice::Axis>& others = graph.runs[at(mate)].axes;
    const bool common = std::find(others.begin(), others.end(), axis) != others.end();
    if (options_.parts.turns && common && (axis == mine.axis || !layout::hasArms(mine)) &&
        (axis == theirs.axis || !layout::hasArms(theirs))) {
      return axis;
    }
  }
  return std::nullopt;
}

//! Lays a bent beam where this run and another meet.
bool Annealer::bend(int run, double noise) {
  const int mate = pickPartner(run);
  const std::optional<lattice::Axis> common = mate < 0 ? std::nullopt : bendAxis(run, mate);
  if (!common) {
    return false;
  }
  const lattice::Axis axis = *common;
  const guide::GuidingGraph& graph = problem_->graph;
  const layout::Cover& mine = layout_.run(run).cover;
  const layout::Cover& theirs = layout_.run(mate).cover;
  std::vector<layout::Beam> fixed = layout::armsOf(mine);
  std::vector<layout::Beam> mateFixed = layout::armsOf(theirs);
  const int layer = static_cast<int>(rng_.below(3)) - 1;
  if (!orbits_.mayBend(run, mate, axis, layer)) {
    return false;
  }
  bends_.clear();
  for (const int form : options_.bends) {
    layout::addBends(graph, form, run, mate, layer, &bends_);
  }
  const int edges = graph.runs[at(run)].edgeCount();
  const int mateEdges = graph.runs[at(mate)].edgeCount();
  const bool cheapest = rng_.unit() < kPickCheapBend;
  double least = kNone;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < bends_.size(); ++i) {
    const layout::Bend bend = bends_[i];
    const double rest =
        cheapest ? beamsBeside(bend.arm, edges) + beamsBeside(bend.mateArm, mateEdges) : 0.0;
    if (rest > least || meetsAny(bend.arm, fixed) || meetsAny(bend.mateArm, mateFixed)) {
      continue;
    }
    kept = rest < least ? 0 : kept;
    least = rest;
    bends_[kept++] = bend;
  }
  if (kept == 0) {
    return false;
  }
  const layout::Bend bend = bends_[rng_.below(static_cast<std::uint32_t>(kept))];
  fixed.push_back(bend.arm);
  mateFixed.push_back(bend.mateArm);
  place(run, {axis, {}});
  place(mate, {axis, {}});
  if (!coverRun(run, axis, noise, fixed) || !coverRun(mate, axis, noise, mateFixed)) {
    return false;
  }
  // Both lines' layers have changed along their length: let those that cross them follow.
  const std::uint32_t followers = rng_.below(kMostFollowers);
  for (std::uint32_t i = 0; i < followers; ++i) {
    const int other = pickPartner(i % 2 == 0 ? run : mate);
    if (other >= 0 && other != run && other != mate) {
      recover(other, noise);
    }
  }
  return true;
}

}  // namespace liftarm::search
