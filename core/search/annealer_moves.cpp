#include <algorithm>

#include "base/det_math.h"
#include "search/annealer.h"

namespace liftarm::search {

namespace {

constexpr double kPickViolation = 0.75;  // share of moves at a violated place while there is one
constexpr double kPickLoose = 0.7;       // while stiffening: of moves at a run that can move
constexpr double kPickNear = 0.15;       // of these: at a run that passes near, not one that is met
constexpr double kTurnMany = 0.3;        // the same where several runs are cleared
constexpr double kPickTwo = 0.35;        // share of moves that cover two runs anew
constexpr double kPickMany = 0.4;  // share of moves that clear several runs first, while violated
constexpr std::uint32_t kMostMany = 4;
constexpr double kPickCostly =
    0.5;  // share of moves at a run with more beams than it needs, if any
constexpr double kPickMirror = 0.05;  // share of moves that mirror a run's layers
constexpr double kPickShift = 0.06;   // share of moves that shift a whole plane
constexpr double kPickBendStiff = 0.25;
constexpr double kPickBend = 0.12;    // share of moves that lay a bent beam
constexpr double kPickFrame = 0.1;    // share of moves that lay a frame, where one may save beams
constexpr double kStraighten = 0.25;  // share of moves on a run with bent beams that take them out
constexpr double kNearLayers = 0.3;   // share of moves that use one layer on either side at most
constexpr double kMoreLayers = 0.6;   // of the others: those that use two
constexpr double kMostNoise = 9.0;
constexpr double kMirrorNoise = 0.2;  // of the others' noise: what follows is to fit
constexpr double kNoLimit = 1e300;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

//! A run at a violated place, if there is one and the dice say so; else any run.
int Annealer::pickRun() {
  const auto runs = static_cast<std::uint32_t>(problem_->graph.runs.size());
  site_ = -1;
  if (stiffening_ && !looseRuns_.empty() && layout_.tallies().violations() == 0 &&
      rng_.unit() < kPickLoose) {
    return looseRuns_[rng_.below(static_cast<std::uint32_t>(looseRuns_.size()))];
  }
  if (!focus_.empty() && (layout_.tallies().violations() == 0 || rng_.unit() >= kPickViolation)) {
    return focus_[rng_.below(static_cast<std::uint32_t>(focus_.size()))];
  }
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
  if (mustHaveAxle_[at(run)] != 0) {
    return layAxleOn(run);
  }
  coverer_.setFixed(fixed);
  if (supply_.limited()) {
    coverer_.setLengthCosts(supply_.lengthCosts(layout_, run, options_.lengths, violationWeight_));
  }
  if (orbits_.binds(run)) {
    const layout::Cover before = layout_.run(run).cover;
    const auto symmetric = orbits_.propose(&coverer_, &layout_, run, axis, noise, &rng_);
    coverer_.setFixed({});
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

//! Covers a run anew; its arms of bent beams and frames stay, and then so does its hole axis.
bool Annealer::recover(int run, double noise, double turning) {
  const guide::GuideRun& guideRun = problem_->graph.runs[at(run)];
  lattice::Axis axis = layout_.run(run).cover.axis;
  const std::vector<layout::Beam> arms = layout::armsOf(layout_.run(run).cover);
  if (!arms.empty() && rng_.unit() < kStraighten) {
    return straighten(run, noise);
  }
  if (options_.parts.turns && arms.empty() && guideRun.axes.size() > 1 && rng_.unit() < turning) {
    axis = guideRun.axes[0] == axis ? guideRun.axes[1] : guideRun.axes[0];
  }
  return coverRun(run, axis, noise, arms);
}

//! Ruin and recreate: clears the run and some that meet or pass near it, then covers them one by
//! one in a random order. What one run alone cannot do, since its neighbours stand in the way,
//! several can.
bool Annealer::recoverMany(int run, double noise) {
  if (layout::hasArms(layout_.run(run).cover)) {
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
    if (other >= 0 && !layout::hasArms(layout_.run(other).cover) &&
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
      if (incidence.run != run && !layout::hasArms(layout_.run(incidence.run).cover)) {
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
  if (problem_->graph.runs[at(run)].exact || layout::hasArms(cover) || cover.axle.used()) {
    return false;
  }
  const guide::SelfBinding binding =
      orbits_.active() ? orbits_.orbits().binding(run, cover.axis) : guide::SelfBinding{};
  if (binding.pinned || binding.sign < 0) {
    return false;
  }
  const int sum = rng_.below(2) == 0 ? 1 : -1;
  const int farthest = guide::kMaxLayer - orbits_.farthestLift(run, cover.axis);
  for (layout::Beam& beam : cover.beams) {
    beam.layer = sum - beam.layer;
    if (beam.layer > farthest || beam.layer < -farthest) {
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
  // What grows from an earlier layout is to stay as it was beyond the runs that were touched.
  const bool calm = grown_ && layout_.tallies().violations() == 0;
  const bool corner =
      !many && !calm && parts.corners && rng_.unit() < (stiffening_ ? kPickBendStiff : kPickBend);
  const bool framed = !many && !calm && !corner && !frameSites_.empty() && rng_.unit() < kPickFrame;
  const bool mirrored =
      !many && !corner && !framed && parts.mirrors && !calm && rng_.unit() < kPickMirror;
  const bool shifted =
      !many && !corner && !framed && !mirrored && parts.shifts && !calm && rng_.unit() < kPickShift;
  bool changed = false;
  if (many) {
    changed = recoverMany(run, noise);
  } else if (shifted) {
    changed = shift(run);
  } else if (mirrored) {
    changed = mirror(run, kMirrorNoise * noise);
  } else if (corner) {
    changed = bend(run, noise);
  } else if (framed) {
    changed = layFrame(noise);
  } else {
    changed = recover(run, noise);
    const int partner = parts.pairs && !calm && rng_.unit() < kPickTwo ? pickPartner(run) : -1;
    changed = (partner >= 0 && recover(partner, noise)) || changed;
  }
  if (!changed) {
    layout_.revert();
    return;
  }
  relayAxles();
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
  findLooseRuns();
  keepBest();
}

}  // namespace liftarm::search
