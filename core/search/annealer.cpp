#include "search/annealer.h"

#include <algorithm>
#include <tuple>

#include "base/det_math.h"
#include "guide/beam_bound.h"
#include "guide/layer_field.h"
#include "guide/orientation.h"

namespace liftarm::search {

namespace {

constexpr std::uint64_t kPatience =
    150;  // moves without a change of violations before weights rise

// Most sketches are whole after the first round, and seldom better for a longer one; those that are
// not need all the later ones.
constexpr double kFirstRoundShare = 0.6;

constexpr std::uint32_t kRoundsPerStart = 3;
constexpr std::uint32_t kSymmetricRounds = 6;      // with every symmetry that may be kept
constexpr std::uint32_t kLastSymmetricRound = 12;  // with some of them
constexpr int kFirstTries = 16;                    // at a first cover that obeys the symmetries
constexpr int kLaterStarts = 4;                    // of stage one: few, so that they differ
constexpr int kStageOneBudget = 30000;             // starts times runs of stage one

// A part beyond those owned weighs less than any other violation.
constexpr double kMissingShare = 0.4;
constexpr double kSame = 1e-9;

// What a beam and a mechanism that are looked at take, measured over the shared sketches: about
// nanoseconds.
constexpr double kWorkOfBeam = 10.0;
constexpr double kWorkOfMechanism = 12.0;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

double weightOf(const objective::Weights& weights, std::string_view term) {
  return weights[*objective::termIndex(term)];
}

CoverCosts coverCosts(const objective::Weights& w) {
  CoverCosts costs;
  costs.beam = weightOf(w, "beams");
  costs.hole = weightOf(w, "holes");
  costs.layerHole = weightOf(w, "layers");
  costs.hinge = weightOf(w, "hinges");
  costs.overhang = weightOf(w, "overhang");
  costs.violation = weightOf(w, "violations");
  return costs;
}

}  // namespace

Annealer::Annealer(const layout::LayoutProblem& problem,
                   layout::ConnectionSolver& solver,
                   AnnealingOptions options)
    : problem_(&problem),
      solver_(&solver),
      options_(std::move(options)),
      rng_(options_.seed),
      layout_(problem, solver),
      coverer_(problem, options_.lengths, coverCosts(options_.weights)),
      orbits_(problem, options_.lengths),
      supply_(options_.supply, solver.table()),
      softWeights_(options_.weights),
      violationWeight_(weightOf(options_.weights, "violations")) {
  measures_.scale = objective::scaleOf(problem.graph);
  if (!options_.parts.orbits) {
    orbits_.releaseAll();
  }
  for (const guide::GuideRun& run : problem.graph.runs) {
    fewestBeams_.push_back(guide::fewestBeams(problem.graph, run));
  }
  findAxleRuns();
  softWeights_[*objective::termIndex("violations")] = 0.0;
  findUsefulSites();
}

double Annealer::plainEnergy(const layout::Tallies& tallies, int freedoms) const {
  measures_.tallies = tallies;
  return objective::value(measures_, softWeights_) + freedomCost_ * freedoms;
}

double Annealer::energy() {
  missing_ = supply_.missing(layout_);
  return plainEnergy(layout_.tallies(), freedoms_) +
         violationWeight_ *
             (layout_.weightedViolations() + kMissingShare * static_cast<double>(missing_));
}

double Annealer::fraction() const {
  if (done_) {
    return 1.0;
  }
  const auto inRound = static_cast<double>(iteration_ - roundBegin_);
  const double share = roundLength_ == 0 ? 0.0 : inRound / static_cast<double>(roundLength_);
  return std::min(0.99,
                  (static_cast<double>(round_) + share) / (static_cast<double>(round_) + 1.0));
}

const char* Annealer::phase() const {
  if (!started_) {
    return "stageOne";
  }
  return done_ ? "done" : "stageTwo";
}

void Annealer::start() {
  started_ = true;
  if (!layEarlier()) {
    beginAfresh();
    return;
  }
  beginRound();
  keepBest();
  done_ = focus_.empty() && keepsUp() && !withdrawFrames();
}

void Annealer::beginAfresh() {
  releaseAxleRuns();
  // Fewer starts for very large sketches, so that the first layout does not keep a person waiting.
  const auto runs = static_cast<int>(problem_->graph.runs.size());
  layFirst(std::max(1, std::min(options_.starts, kStageOneBudget / std::max(1, runs))));
  beginRound();
  keepBest();
}

//! Hole axes from stage one, then every run covered once.
void Annealer::layFirst(int starts) {
  const auto runs = static_cast<int>(problem_->graph.runs.size());
  const bool bound = orbits_.active();
  guide::Orientation orientation =
      bound ? guide::estimateOrientation(problem_->graph, orbits_.orbits(), starts, &rng_)
            : guide::estimateOrientation(problem_->graph, starts, &rng_);
  turnToAxles(&orientation);
  // The first covers see hole axes but no beams; the later ones see what was laid before them.
  for (int r = 0; r < runs; ++r) {
    layout_.setCover(r, {orientation[at(r)], {}});
  }
  const guide::LayerField field = guide::makeLayerField(problem_->graph, orientation, &rng_);
  for (int r = 0; r < runs; ++r) {
    coverer_.setPreferred(options_.parts.walls ? &field[at(r)] : nullptr);
    if (orbits_.binds(r) && orbits_.orbits().representative(r) != r) {
      continue;  // covered with the first of its images
    }
    if (mustHaveAxle_[at(r)] != 0) {
      layAxleOn(r);  // laid anew when all are there
      continue;
    }
    if (orbits_.binds(r) && layBound(r, orientation[at(r)])) {
      continue;
    }
    if (auto cover = coverer_.propose(layout_, r, orientation[at(r)], 0.5, &rng_)) {
      layout_.setCover(r, std::move(*cover));
    }
  }
  coverer_.setPreferred(nullptr);
  relayAxles();
  layout_.settleAll();
  layout_.keep();
  energy_ = energy();
}

//! Covers a run and its images for the first time; frees them when no cover suits them all.
bool Annealer::layBound(int run, lattice::Axis axis) {
  for (int i = 0; i < kFirstTries; ++i) {
    if (coverRun(run, axis, 0.5, {})) {
      return true;
    }
  }
  orbits_.release(run);
  return false;
}

void Annealer::beginRound() {
  roundBegin_ = iteration_;
  const double share =
      stiffening_ ? options_.stiffening.share : (round_ == 0 ? kFirstRoundShare : 1.0);
  const double perRuns = static_cast<double>(options_.iterationsPerRun) *
                         static_cast<double>(grown_ ? focus_.size() : problem_->graph.runs.size());
  const double least = static_cast<double>(options_.minIterations);
  roundLength_ = static_cast<std::uint64_t>((stiffening_ ? share : 1.0) * least) +
                 static_cast<std::uint64_t>(share * perRuns);
  temperature_ = options_.startTemperature;
  lastChange_ = iteration_;
}

void Annealer::finishRound() {
  if (trying_) {
    finishTrial();
    return;
  }
  if (grown_ && !keepsUp()) {
    startOver();
    return;
  }
  ++round_;
  const bool whole = hasWhole();
  if (whole && !again_ && !stiffening_ && withdrawFrames()) {
    return;
  }
  if (whole && options_.freedoms && !grown_ && !isOverworked()) {
    goOnStiffening();
    return;
  }
  if (whole || round_ > options_.maxRounds) {
    finish();
    return;
  }
  if (round_ % kRoundsPerStart == 0) {
    loosenSymmetry();
    layAgain();
  }
  beginRound();
}

bool Annealer::hasWhole() const {
  return best_.tallies.violations() + best_.missing == 0;
}

double Annealer::work() const {
  return kWorkOfBeam * static_cast<double>(coverer_.work()) +
         kWorkOfMechanism * static_cast<double>(solver_->work());
}

bool Annealer::isOverworked() const {
  return work() > (hasWhole() ? options_.mostWork : options_.mostWorkUntilWhole);
}

//! What one start cannot do another may: other hole axes, and no grudges.
void Annealer::layAgain() {
  layout_.setWeights(std::vector<double>(problem_->graph.junctions.size(), 1.0),
                     std::vector<double>(problem_->graph.runs.size(), 1.0));
  coverer_.setReach(guide::kMaxLayer);
  layFirst(kLaterStarts);
}

//! Where a symmetric layout could not be made whole, the runs there are freed; at last, all are.
void Annealer::loosenSymmetry() {
  if (!orbits_.active() || round_ < kSymmetricRounds) {
    return;
  }
  if (round_ >= kLastSymmetricRound) {
    orbits_.releaseAll();
    return;
  }
  for (std::size_t j = 0; j < best_.junctions.size(); ++j) {
    if (orbits_.active() && best_.junctions[j].violations() > 0) {
      orbits_.releaseAt(static_cast<int>(j));
    }
  }
}

LayoutSnapshot Annealer::snapshot() const {
  LayoutSnapshot snapshot;
  snapshot.tallies = layout_.tallies();
  for (std::size_t r = 0; r < problem_->graph.runs.size(); ++r) {
    snapshot.covers.push_back(layout_.run(static_cast<int>(r)).cover);
  }
  for (std::size_t j = 0; j < problem_->graph.junctions.size(); ++j) {
    snapshot.junctions.push_back(layout_.junction(static_cast<int>(j)));
  }
  return snapshot;
}

void Annealer::keepBest() {
  if (trying_) {
    keepBestTrial();
    return;
  }
  LayoutSnapshot& best = again_ ? bestAgain_ : best_;
  const int violations = layout_.tallies().violations();
  const double plain = plainEnergy(layout_.tallies(), freedoms_);
  // A whole model with parts to buy says more than one that falls apart for want of them.
  const auto rank = std::tuple(violations, missing_, plain + kSame);
  const bool better = best.covers.empty() ||
                      rank < std::tuple(best.tallies.violations(), best.missing, best.energy);
  if (!better) {
    return;
  }
  LayoutSnapshot candidate = snapshot();
  if (stiffening_ && !isBuildable(candidate)) {
    return;
  }
  best = std::move(candidate);
  best.energy = plain;
  best.missing = missing_;
  best.freedoms = freedoms_;
  if (!again_) {
    ++improvements_;
  } else if (stiffening_) {
    offerAgain();
  }
}

void Annealer::raiseWeights() {
  std::vector<double> junctionWeights = layout_.junctionWeights();
  std::vector<double> runWeights = layout_.runWeights();
  for (std::size_t j = 0; j < junctionWeights.size(); ++j) {
    if (layout_.junction(static_cast<int>(j)).violations() > 0) {
      junctionWeights[j] += 0.5;
    } else {
      junctionWeights[j] = 1.0 + (junctionWeights[j] - 1.0) * 0.95;
    }
  }
  for (std::size_t r = 0; r < runWeights.size(); ++r) {
    const layout::RunState& state = layout_.run(static_cast<int>(r));
    if (state.collisions + state.forbidden > 0) {
      runWeights[r] += 0.5;
    } else {
      runWeights[r] = 1.0 + (runWeights[r] - 1.0) * 0.95;
    }
  }
  layout_.setWeights(std::move(junctionWeights), std::move(runWeights));
  energy_ = energy();
}

bool Annealer::advance(std::uint32_t iterations) {
  if (!started_) {
    start();
  }
  for (std::uint32_t i = 0; i < iterations && !done_; ++i) {
    const double share =
        static_cast<double>(iteration_ - roundBegin_) / static_cast<double>(roundLength_);
    if ((iteration_ & 15U) == 0) {
      // A round may start from another temperature than the one before it, in mid-slice.
      const double ratio = options_.endTemperature / options_.startTemperature;
      temperature_ = options_.startTemperature * base::detExp(base::detLog(ratio) * share);
      done_ = isOverworked() && !hasWhole();
    }
    move();
    ++iteration_;
    if (options_.parts.growth && layout_.tallies().violations() > 0 &&
        iteration_ - lastChange_ > kPatience) {
      raiseWeights();
      lastChange_ = iteration_;
    }
    if (iteration_ - roundBegin_ >= roundLength_) {
      finishRound();
    }
  }
  return done_;
}

}  // namespace liftarm::search
