#include "search/paper_search.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/det_math.h"
#include "layout/components.h"
#include "layout/stack.h"
#include "objective/rigidity_measure.h"

namespace liftarm::search {

namespace {

using guide::kMaxLayer;
using layout::kLayerCount;

constexpr double kSimpleRate = 0.999;
constexpr double kComplexRate = 0.99997;
constexpr double kTurnShare = 0.05;
constexpr double kLayerNoise = 1.5;
constexpr double kOccupied = 2.0;   // an occupied node against a gap
constexpr double kForbidden = 1e6;  // off an exact line
constexpr double kOutside = 100.0;  // a hole below the ground or in a keep-out box
constexpr double kOffLine = 0.1;    // keeps stacks from drifting away
constexpr int kPicks = 64;          // tries to find an edge that can be covered
constexpr double kSame = 1e-9;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

void drop(objective::Weights* weights, std::string_view term) {
  (*weights)[*objective::termIndex(term)] = 0.0;
}

}  // namespace

PaperSearch::PaperSearch(const layout::LayoutProblem& problem,
                         layout::ConnectionSolver& solver,
                         PaperOptions options)
    : problem_(&problem),
      options_(std::move(options)),
      rng_(options_.seed),
      layout_(problem, solver),
      simpleWeights_(options_.weights),
      temperature_(options_.startTemperature) {
  for (const char* term : {"col", "coh", "phr", "rgd"}) {
    drop(&simpleWeights_, term);
  }
  measures_.scale = objective::scaleOf(problem.graph);
  for (const guide::GuideSymmetry& s : problem.graph.symmetries) {
    symmetries_.push_back({{s.linear, s.shift}, s.runs, s.partners});
  }
  if (options_.coolingRate == 0.0) {
    const bool complex = static_cast<int>(problem.graph.nodes.size()) >= kComplexNodes;
    options_.coolingRate = complex ? kComplexRate : kSimpleRate;
  }
  for (std::size_t r = 0; r < problem.graph.runs.size(); ++r) {
    for (int e = 0; e < problem.graph.runs[r].edgeCount(); ++e) {
      edges_.emplace_back(static_cast<int>(r), e);
    }
  }
}

double PaperSearch::fraction() const {
  if (done_) {
    return 1.0;
  }
  const double all = base::detLog(options_.endTemperature / options_.startTemperature);
  const double now = base::detLog(temperature_ / options_.startTemperature);
  return std::min(0.99, now / all);
}

const char* PaperSearch::phase() const {
  if (!beams_) {
    return "stageOne";
  }
  return done_ ? "done" : "stageTwo";
}

void PaperSearch::start() {
  beams_.emplace(*problem_, paperStageOne(problem_->graph, &rng_), options_.lengths);
  components_ = layout::findComponents(problem_->graph, beams_->covers());
  initialise();
  beams_->settle();
  beams_->keep();
  measure();
  energy_ = objective();
  keepBest();
}

//! The first layout (5.3): random uncovered edges, each covered by any placement, all alike likely.
void PaperSearch::initialise() {
  std::vector<std::pair<int, int>> order = edges_;
  for (std::size_t i = order.size(); i > 1; --i) {
    std::swap(order[i - 1], order[rng_.below(static_cast<std::uint32_t>(i))]);
  }
  for (const auto& [run, edge] : order) {
    if (!beams_->coverable(run, edge) || beams_->covered(run, edge)) {
      continue;
    }
    std::vector<PaperPlacement> fitting;
    for (const PaperPlacement& p : beams_->placements({run}, options_.corners)) {
      if (p.start <= edge && p.start + p.holes - 1 > edge) {
        fitting.push_back(p);
      }
    }
    if (!fitting.empty()) {
      const PaperPlacement& p = fitting[rng_.below(static_cast<std::uint32_t>(fitting.size()))];
      beams_->add(p, pickLayer(p));
    }
  }
}

//! Adds up what each layer costs at the nodes of one arm.
void PaperSearch::addLayerCosts(int run, int start, int holes, std::vector<double>* costs) const {
  const guide::GuideRun& guideRun = problem_->graph.runs[at(run)];
  const lattice::Axis axis = beams_->cover(run).axis;
  const bool restricted = problem_->graph.ground || !problem_->graph.keepOut.empty();
  for (int i = start; i < start + holes; ++i) {
    const unsigned layers = beams_->layersAt(run, i);
    const int gaps = layout::stackFaults(layers).gaps;
    for (int layer = -kMaxLayer; layer <= kMaxLayer; ++layer) {
      const unsigned own = 1U << static_cast<unsigned>(layer + kMaxLayer);
      double cost = (layers & own) != 0
                        ? kOccupied
                        : static_cast<double>(layout::stackFaults(layers | own).gaps - gaps);
      if (restricted &&
          layout::forbiddenAt(problem_->graph,
                              layout::holePosition(problem_->graph, guideRun, axis, i, layer))) {
        cost += kOutside;
      }
      cost += guideRun.exact && layer != 0 ? kForbidden : 0.0;
      (*costs)[at(layer + kMaxLayer)] += cost;
    }
  }
}

//! "At a layer that produces more compact layering" (5.2).
int PaperSearch::pickLayer(const PaperPlacement& placement) {
  std::vector<double> costs(at(kLayerCount), 0.0);
  addLayerCosts(placement.run, placement.start, placement.holes, &costs);
  if (placement.mate >= 0) {
    addLayerCosts(placement.mate, placement.mateStart, placement.mateHoles, &costs);
  }
  for (int layer = -kMaxLayer; layer <= kMaxLayer; ++layer) {
    costs[at(layer + kMaxLayer)] +=
        kOffLine * static_cast<double>(layer < 0 ? -layer : layer) + kLayerNoise * rng_.unit();
  }
  return static_cast<int>(std::min_element(costs.begin(), costs.end()) - costs.begin()) - kMaxLayer;
}

//! Draws placements until every edge that became uncovered is covered again.
void PaperSearch::coverAgain() {
  while (true) {
    const std::vector<PaperPlacement> candidates =
        beams_->placements(beams_->touched(), options_.corners);
    if (candidates.empty()) {
      return;
    }
    std::uint32_t sum = 0;
    for (const PaperPlacement& p : candidates) {
      sum += static_cast<std::uint32_t>(p.covers);
    }
    std::uint32_t draw = rng_.below(sum);
    std::size_t chosen = 0;
    while (draw >= static_cast<std::uint32_t>(candidates[chosen].covers)) {
      draw -= static_cast<std::uint32_t>(candidates[chosen].covers);
      ++chosen;
    }
    beams_->add(candidates[chosen], pickLayer(candidates[chosen]));
  }
}

//! The layout modification operator (5.2).
void PaperSearch::modify() {
  for (int pick = 0; pick < kPicks; ++pick) {
    const auto [run, edge] = edges_[rng_.below(static_cast<std::uint32_t>(edges_.size()))];
    if (!beams_->coverable(run, edge)) {
      continue;
    }
    const std::vector<lattice::Axis>& axes = problem_->graph.runs[at(run)].axes;
    if (full_ && axes.size() > 1 && rng_.unit() < kTurnShare) {
      beams_->turn(run, axes[0] == beams_->cover(run).axis ? axes[1] : axes[0]);
    } else {
      beams_->removeAround(run, edge);
    }
    coverAgain();
    return;
  }
}

//! Brings the measures up to date with the beams and, in the full objective, their connections.
void PaperSearch::measure() {
  layout::Tallies& tallies = measures_.tallies;
  const PaperSums& sums = beams_->sums();
  if (full_) {
    tallies = layout_.tallies();
  }
  tallies.beams = sums.beams;
  tallies.holes = sums.holes;
  tallies.layerSquares = sums.layerSquares;
  tallies.gaps = sums.gaps;
  tallies.collisions = sums.ownCollisions + (full_ ? layout_.tallies().collisions : 0);
  tallies.failedConnections =
      sums.ownFailures + sums.uncovered + (full_ ? layout_.tallies().failedConnections : 0);
  measures_.componentRange = layout::largestLayerRange(components_, beams_->covers());
  const objective::Weights& weights = full_ ? options_.weights : simpleWeights_;
  if (weights[*objective::termIndex("sym")] > 0.0) {
    measures_.symmetryDeviation =
        objective::symmetryDeviation(problem_->graph, beams_->covers(), symmetries_);
  }
  if (weights[*objective::termIndex("rgd")] > 0.0) {
    std::vector<layout::JunctionState> junctions;
    for (std::size_t j = 0; j < problem_->graph.junctions.size(); ++j) {
      junctions.push_back(layout_.junction(static_cast<int>(j)));
    }
    measures_.rigidSubsets =
        objective::countRigidSubsets(problem_->graph, layout_.table(), beams_->covers(), junctions);
  }
}

double PaperSearch::objective() {
  return objective::value(measures_, full_ ? options_.weights : simpleWeights_);
}

void PaperSearch::useFullObjective() {
  full_ = true;
  for (std::size_t r = 0; r < problem_->graph.runs.size(); ++r) {
    layout_.setCover(static_cast<int>(r), beams_->cover(static_cast<int>(r)));
  }
  layout_.settleAll();
  layout_.keep();
  measure();
  energy_ = objective();
  best_.covers.clear();  // values of the two objectives cannot be compared
  keepBest();
}

void PaperSearch::move() {
  modify();
  beams_->settle();
  if (full_) {
    for (const int run : beams_->touched()) {
      layout_.setCover(run, beams_->cover(run));
    }
    layout_.settle();
  }
  const bool turned = beams_->turned();
  if (turned) {
    components_ = layout::findComponents(problem_->graph, beams_->covers());
  }
  const objective::Measures before = measures_;
  measure();
  const double after = objective();
  if (base::detExp((energy_ - after) / temperature_) > rng_.unit()) {
    beams_->keep();
    layout_.keep();
    energy_ = after;
    keepBest();
    return;
  }
  beams_->revert();
  layout_.revert();
  measures_ = before;
  if (turned) {
    components_ = layout::findComponents(problem_->graph, beams_->covers());
  }
}

void PaperSearch::keepBest() {
  const int violations = full_ ? measures_.tallies.violations() : 0;
  const int bestViolations = full_ ? best_.tallies.violations() : 0;
  const bool better = best_.covers.empty() || violations < bestViolations ||
                      (violations == bestViolations && energy_ < best_.energy - kSame);
  if (!better) {
    return;
  }
  ++improvements_;
  best_.tallies = measures_.tallies;
  best_.energy = energy_;
  best_.covers = beams_->covers();
  best_.junctions.clear();
  for (std::size_t j = 0; j < problem_->graph.junctions.size(); ++j) {
    best_.junctions.push_back(layout_.junction(static_cast<int>(j)));
  }
}

bool PaperSearch::advance(std::uint32_t iterations) {
  if (!beams_) {
    start();
  }
  for (std::uint32_t i = 0; i < iterations && !done_; ++i) {
    if (!full_ && temperature_ < options_.middleTemperature) {
      useFullObjective();
    }
    move();
    ++iteration_;
    temperature_ *= options_.coolingRate;
    done_ = temperature_ <= options_.endTemperature;
  }
  return done_;
}

}  // namespace liftarm::search
