#include <algorithm>

#include "base/det_math.h"
#include "search/annealer.h"

namespace liftarm::search {

namespace {

constexpr double kPickViolation = 0.75;  // share of moves at a violated place while there is one
constexpr double kPickNear = 0.15;       // of these: at a run that passes near, not one that is met
constexpr double kPickAxis = 0.12;       // share of moves that turn the run's hole axis
constexpr double kTurnMany = 0.3;        // the same where several runs are cleared
constexpr double kPickTwo = 0.35;        // share of moves that cover two runs anew
constexpr double kPickMany = 0.4;  // share of moves that clear several runs first, while violated
constexpr std::uint32_t kMostMany = 4;
constexpr double kPickCostly =
    0.5;  // share of moves at a run with more beams than it needs, if any
constexpr double kPickMirror = 0.05;  // share of moves that mirror a run's layers
constexpr double kPickBendStiff = 0.25;
constexpr double kPickVariant = 0.5;  // share of moves of a stiffening round that change no beam
constexpr double kPickBend = 0.12;       // share of moves that lay a bent beam
constexpr double kPickCheapBend = 0.75;  // of these: those that leave the fewest beams beside it
constexpr double kSticksOut = 0.2;       // beams
constexpr double kStraighten = 0.25;  // share of moves on a run with bent beams that take them out
constexpr std::uint32_t kMostFollowers = 7;
constexpr double kNearLayers = 0.3;  // share of moves that use one layer on either side at most
constexpr double kMoreLayers = 0.6;  // of the others: those that use two
constexpr double kMostNoise = 9.0;
constexpr double kMirrorNoise = 0.2;  // of the others' noise: what follows is to fit
constexpr double kNoLimit = 1e300;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

std::vector<layout::Beam> armsOf(const layout::Cover& cover) {
  std::vector<layout::Beam> arms;
  for (const layout::Beam& beam : cover.beams) {
    if (beam.mate >= 0) {
      arms.push_back(beam);
    }
  }
  return arms;
}

//! The beams of a cover without the arm whose other one is on `mate`; -2 takes out every arm.
std::vector<layout::Beam> withoutMates(const std::vector<layout::Beam>& beams, int mate) {
  std::vector<layout::Beam> rest;
  for (const layout::Beam& beam : beams) {
    if (beam.mate < 0 || (mate != -2 && beam.mate != mate)) {
      rest.push_back(beam);
    }
  }
  return rest;
}

//! Beams that the rest of a run needs beside an arm, about; sticking out counts a little.
double beamsBeside(const layout::Beam& arm, int edges) {
  const auto beams = [](int left) {
    return left <= 0 ? 0 : (left + guide::kLongestBeam - 1) / guide::kLongestBeam;
  };
  const int past = (arm.solidStart() < 0 ? 1 : 0) + (arm.solidLast() > edges ? 1 : 0);
  return static_cast<double>(beams(arm.start) + beams(edges - arm.last())) +
         kSticksOut * static_cast<double>(past);
}

//! Whether an arm would share a node with one of these.
bool meetsAny(const layout::Beam& arm, const std::vector<layout::Beam>& others) {
  return std::any_of(others.begin(), others.end(), [&](const layout::Beam& other) {
    return arm.solidStart() <= other.solidLast() && arm.solidLast() >= other.solidStart();
  });
}

}  // namespace

//! A run at a violated place, if there is one and the dice say so; else any run.
int Annealer::pickRun() {
  const auto runs = static_cast<std::uint32_t>(problem_->graph.runs.size());
  site_ = -1;
  if (!options_.parts.focus || layout_.tallies().violations() == 0 ||
      rng_.unit() >= kPickViolation) {
    const int costly = options_.parts.costly && rng_.unit() < kPickCostly ? pickCostlyRun() : -1;
    if (costly >= 0) {
      return costly;
    }
    return static_cast<int>(rng_.below(runs));
  }
  sites_.clear();
  for (std::size_t j = 0; j < problem_->graph.junctions.size(); ++j) {
    if (layout_.junction(static_cast<int>(j)).violations() > 0) {
      sites_.push_back(static_cast<int>(j));
    }
  }
  const std::size_t junctions = sites_.size();
  for (std::uint32_t r = 0; r < runs; ++r) {
    const layout::RunState& state = layout_.run(static_cast<int>(r));
    if (state.collisions + state.forbidden > 0) {
      sites_.push_back(static_cast<int>(r));
    }
  }
  if (sites_.empty()) {
    return static_cast<int>(rng_.below(runs));
  }
  const std::size_t pick = rng_.below(static_cast<std::uint32_t>(sites_.size()));
  if (pick >= junctions) {
    return sites_[pick];
  }
  site_ = sites_[pick];
  const guide::Junction& junction = problem_->graph.junctions[at(site_)];
  if (rng_.unit() < kPickNear) {
    return junction.nearRuns[rng_.below(static_cast<std::uint32_t>(junction.nearRuns.size()))];
  }
  return junction.incident[rng_.below(static_cast<std::uint32_t>(junction.incident.size()))].run;
}

//! A run with more beams than it needs, or one that meets it; -1: there is none.
int Annealer::pickCostlyRun() {
  sites_.clear();
  for (std::size_t r = 0; r < fewestBeams_.size(); ++r) {
    if (static_cast<int>(layout_.run(static_cast<int>(r)).cover.beams.size()) > fewestBeams_[r]) {
      sites_.push_back(static_cast<int>(r));
    }
  }
  if (sites_.empty()) {
    return -1;
  }
  const int run = sites_[rng_.below(static_cast<std::uint32_t>(sites_.size()))];
  const int partner = rng_.below(2) == 0 ? pickPartner(run) : -1;
  return partner >= 0 ? partner : run;
}

//! Another run that meets this one, or -1.
int Annealer::pickPartner(int run) {
  const std::vector<int>& met = problem_->graph.runs[at(run)].junctions;
  if (met.empty()) {
    return -1;
  }
  const guide::Junction& junction =
      problem_->graph.junctions[at(met[rng_.below(static_cast<std::uint32_t>(met.size()))])];
  const int other =
      junction.incident[rng_.below(static_cast<std::uint32_t>(junction.incident.size()))].run;
  return other == run ? -1 : other;
}

//! Puts a cover on a run, and on those that symmetries bind to it.
void Annealer::place(int run, const layout::Cover& cover) {
  if (orbits_.binds(run)) {
    orbits_.place(&layout_, run, cover);
  } else {
    layout_.setCover(run, cover);
  }
}

bool Annealer::coverRun(int run,
                        lattice::Axis axis,
                        double noise,
                        const std::vector<layout::Beam>& fixed) {
  coverer_.setFixed(fixed);
  if (supply_.limited()) {
    coverer_.setLengthCosts(supply_.lengthCosts(layout_, run, options_.lengths, violationWeight_));
  }
  if (orbits_.binds(run)) {
    const layout::Cover before = layout_.run(run).cover;
    const auto symmetric = orbits_.propose(&coverer_, &layout_, run, axis, noise, &rng_);
    place(run, symmetric ? *symmetric : before);
    return symmetric && !(*symmetric == before);
  }
  auto cover = coverer_.propose(layout_, run, axis, noise, &rng_);
  coverer_.setFixed({});
  if (!cover) {
    return false;
  }
  const bool changed = !(*cover == layout_.run(run).cover);
  if (changed) {
    layout_.setCover(run, std::move(*cover));
  }
  return changed;
}

//! Covers a run anew; its arms of bent beams stay, and then so does its hole axis.
bool Annealer::recover(int run, double noise, double turning) {
  const guide::GuideRun& guideRun = problem_->graph.runs[at(run)];
  lattice::Axis axis = layout_.run(run).cover.axis;
  const std::vector<layout::Beam> arms = armsOf(layout_.run(run).cover);
  if (!arms.empty() && rng_.unit() < kStraighten) {
    return straighten(run, noise);
  }
  if (options_.parts.turns && arms.empty() && guideRun.axes.size() > 1 && rng_.unit() < turning) {
    axis = guideRun.axes[0] == axis ? guideRun.axes[1] : guideRun.axes[0];
  }
  return coverRun(run, axis, noise, arms);
}

//! Takes the bent beams of a run out: it and the runs of their other arms are covered anew.
bool Annealer::straighten(int run, double noise) {
  bool changed = false;
  const std::vector<layout::Beam> arms = armsOf(layout_.run(run).cover);
  layout::Cover bare = layout_.run(run).cover;
  bare.beams = withoutMates(bare.beams, -2);
  layout_.setCover(run, bare);
  for (const layout::Beam& arm : arms) {
    const layout::Cover& cover = layout_.run(arm.mate).cover;
    layout::Cover mate{cover.axis, withoutMates(cover.beams, run)};
    const std::vector<layout::Beam> kept = armsOf(mate);
    layout_.setCover(arm.mate, mate);
    changed = coverRun(arm.mate, mate.axis, noise, kept) || changed;
  }
  return coverRun(run, layout_.run(run).cover.axis, noise, {}) || changed;
}

//! The hole axis that two runs may have in common: theirs, where it is the same, else one that both
//! may turn to. None where a symmetry binds them, or a joint lets them turn against each other.
std::optional<lattice::Axis> Annealer::bendAxis(int run, int mate) const {
  const guide::GuidingGraph& graph = problem_->graph;
  const int junction = layout::commonJunction(graph, run, mate);
  if (orbits_.binds(run) || orbits_.binds(mate) || junction < 0 ||
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
    if (options_.parts.turns && common && (axis == mine.axis || armsOf(mine).empty()) &&
        (axis == theirs.axis || armsOf(theirs).empty())) {
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
  std::vector<layout::Beam> fixed = armsOf(mine);
  std::vector<layout::Beam> mateFixed = armsOf(theirs);
  const int layer = static_cast<int>(rng_.below(3)) - 1;
  bends_.clear();
  for (const int form : options_.bends) {
    layout::addBends(graph, form, run, mate, layer, &bends_);
  }
  const int edges = graph.runs[at(run)].edgeCount();
  const int mateEdges = graph.runs[at(mate)].edgeCount();
  const bool cheapest = rng_.unit() < kPickCheapBend;
  double least = kNoLimit;
  std::size_t kept = 0;
  for (const auto& arms : std::vector(bends_)) {
    const double rest =
        cheapest ? beamsBeside(arms.first, edges) + beamsBeside(arms.second, mateEdges) : 0.0;
    if (rest > least || meetsAny(arms.first, fixed) || meetsAny(arms.second, mateFixed)) {
      continue;
    }
    kept = rest < least ? 0 : kept;
    least = rest;
    bends_[kept++] = arms;
  }
  if (kept == 0) {
    return false;
  }
  const auto [arm, mateArm] = bends_[rng_.below(static_cast<std::uint32_t>(kept))];
  fixed.push_back(arm);
  mateFixed.push_back(mateArm);
  layout_.setCover(run, {axis, {}});
  layout_.setCover(mate, {axis, {}});
  if (!coverRun(run, axis, noise, fixed) || !coverRun(mate, axis, noise, mateFixed)) {
    return false;
  }
  // Both lines' layers have changed along their length: let those that cross them follow.
  const std::uint32_t followers = rng_.below(kMostFollowers);
  for (std::uint32_t i = 0; i < followers; ++i) {
    const int other = pickPartner(i % 2 == 0 ? run : mate);
    if (other >= 0 && other != run && other != mate) {
      recover(other, noise, kPickAxis);
    }
  }
  return true;
}

//! Ruin and recreate: clears the run and some that meet or pass near it, then covers them one by
//! one in a random order. What one run alone cannot do, since its neighbours stand in the way,
//! several can.
bool Annealer::recoverMany(int run, double noise) {
  if (!armsOf(layout_.run(run).cover).empty()) {
    return straighten(run, noise);
  }
  const auto firstOf = [&](int r) {
    return orbits_.binds(r) ? orbits_.orbits().representative(r) : r;
  };
  std::vector<int> cleared{firstOf(run)};
  const guide::GuideRun& guideRun = problem_->graph.runs[at(run)];
  const std::uint32_t wanted = 1 + rng_.below(kMostMany);
  for (std::uint32_t i = 0; i < wanted; ++i) {
    int other = pickPartner(run);
    if (site_ >= 0 && rng_.below(2) == 0) {
      const std::vector<int>& near = problem_->graph.junctions[at(site_)].nearRuns;
      other = near[rng_.below(static_cast<std::uint32_t>(near.size()))];
    } else if (other < 0 && !guideRun.near.empty()) {
      other = guideRun.near[rng_.below(static_cast<std::uint32_t>(guideRun.near.size()))];
    }
    other = other >= 0 ? firstOf(other) : other;
    if (other >= 0 && armsOf(layout_.run(other).cover).empty() &&
        std::find(cleared.begin(), cleared.end(), other) == cleared.end()) {
      cleared.push_back(other);
    }
  }
  std::vector<layout::Cover> before;
  for (const int r : cleared) {
    before.push_back(layout_.run(r).cover);
    place(r, {layout_.run(r).cover.axis, {}});
  }
  for (std::size_t i = cleared.size(); i > 1; --i) {
    const std::size_t j = rng_.below(static_cast<std::uint32_t>(i));
    std::swap(cleared[i - 1], cleared[j]);
    std::swap(before[i - 1], before[j]);
  }
  for (std::size_t i = 0; i < cleared.size(); ++i) {
    if (!recover(cleared[i], noise, kTurnMany)) {
      place(cleared[i], before[i]);
    }
  }
  return true;
}

//! Covers those runs anew that meet this one in a stack with a fault; false when there is none.
bool Annealer::recoverCrossing(int run, double noise) {
  bool any = false;
  for (const int junction : problem_->graph.runs[at(run)].junctions) {
    if (layout_.stackViolationsAt(junction) == 0) {
      continue;
    }
    for (const guide::Incidence& incidence : problem_->graph.junctions[at(junction)].incident) {
      if (incidence.run != run && armsOf(layout_.run(incidence.run).cover).empty()) {
        any = coverRun(incidence.run, layout_.run(incidence.run).cover.axis, noise, {}) || any;
      }
    }
  }
  return any;
}

//! Mirrors the layers of a run, and lets all that cross it follow: where lines change layers, in a
//! grid, is a wall across many lines, which no line can move alone.
bool Annealer::mirror(int run, double noise) {
  layout::Cover cover = layout_.run(run).cover;
  if (problem_->graph.runs[at(run)].exact || !armsOf(cover).empty()) {
    return false;
  }
  const guide::SelfBinding binding =
      orbits_.active() ? orbits_.orbits().binding(run, cover.axis) : guide::SelfBinding{};
  if (binding.pinned || binding.sign < 0) {
    return false;
  }
  const int sum = rng_.below(2) == 0 ? 1 : -1;
  for (layout::Beam& beam : cover.beams) {
    beam.layer = sum - beam.layer;
    if (beam.layer > guide::kMaxLayer || beam.layer < -guide::kMaxLayer) {
      return false;
    }
  }
  place(run, cover);
  if (recoverCrossing(run, noise)) {
    recoverCrossing(run, noise);
  }
  return true;
}

void Annealer::move() {
  const int run = pickRun();
  const SearchParts& parts = options_.parts;
  const double noise = parts.noise ? kMostNoise * rng_.unit() : 0.0;
  coverer_.setReach(rng_.unit() < kNearLayers ? 1
                                              : (rng_.unit() < kMoreLayers ? 2 : guide::kMaxLayer));
  const bool many = parts.many && layout_.tallies().violations() > 0 && rng_.unit() < kPickMany;
  const bool corner =
      !many && parts.corners && rng_.unit() < (stiffening_ ? kPickBendStiff : kPickBend);
  const bool mirrored = !many && !corner && parts.mirrors && rng_.unit() < kPickMirror;
  const bool varied = stiffening_ && parts.variants && rng_.unit() < kPickVariant;
  bool changed = false;
  if (varied) {
    changed = varyConnection(run);
  } else if (many) {
    changed = recoverMany(run, noise);
  } else if (mirrored) {
    changed = mirror(run, kMirrorNoise * noise);
  } else if (corner) {
    changed = bend(run, noise);
  } else {
    changed = recover(run, noise, kPickAxis);
    const int partner = parts.pairs && rng_.unit() < kPickTwo ? pickPartner(run) : -1;
    changed = (partner >= 0 && recover(partner, noise, kPickAxis)) || changed;
  }
  if (!changed) {
    layout_.revert();
    return;
  }
  // The threshold is drawn first, so that a move that cannot pass it is not connected to its end.
  const double chance = rng_.unit();
  const double limit = chance <= 0.0 ? kNoLimit : energy_ - temperature_ * base::detLog(chance);
  if (!passes(limit)) {
    layout_.revert();
    return;
  }
  layout_.keep();
  const double after = energy();
  lastChange_ = after < energy_ - 1e-9 ? iteration_ : lastChange_;
  energy_ = after;
  keepBest();
}

}  // namespace liftarm::search
