#include "search/paper_state.h"

#include "layout/components.h"
#include "objective/rigidity_measure.h"

namespace liftarm::search {

namespace {

constexpr double kTurnShare = 0.05;

objective::Weights simplified(objective::Weights weights) {
  for (const char* term : {"col", "coh", "phr", "rgd"}) {
    weights[*objective::termIndex(term)] = 0.0;
  }
  return weights;
}

}  // namespace

PaperState::PaperState(const layout::LayoutProblem& problem,
                       layout::ConnectionSolver& solver,
                       const PaperStateOptions& options,
                       base::Rng* rng)
    : problem_(&problem),
      weights_(options.weights),
      simpleWeights_(simplified(options.weights)),
      operator_(problem, options.corners, rng),
      layout_(problem, solver),
      beams_(problem, paperStageOne(problem.graph, rng), options.lengths),
      components_(layout::findComponents(problem.graph, beams_.covers())) {
  measures_.scale = objective::scaleOf(problem.graph);
  for (const guide::GuideSymmetry& s : problem.graph.symmetries) {
    symmetries_.push_back({{s.linear, s.shift}, s.runs, s.partners});
  }
  operator_.initialise(&beams_);
  beams_.settle();
  beams_.keep();
  measure();
  energy_ = objective();
}

//! Brings the measures up to date with the beams and, in the full objective, their connections.
void PaperState::measure() {
  layout::Tallies& tallies = measures_.tallies;
  if (full_) {
    tallies = layout_.tallies();
  }
  addPaperSums(beams_.sums(), &tallies, full_);
  measures_.componentRange = layout::largestLayerRange(components_, beams_.covers());
  const objective::Weights& weights = full_ ? weights_ : simpleWeights_;
  if (weights[*objective::termIndex("sym")] > 0.0) {
    measures_.symmetryDeviation =
        objective::symmetryDeviation(problem_->graph, beams_.covers(), symmetries_);
  }
  if (weights[*objective::termIndex("rgd")] > 0.0) {
    std::vector<layout::JunctionState> junctions;
    for (std::size_t j = 0; j < problem_->graph.junctions.size(); ++j) {
      junctions.push_back(layout_.junction(static_cast<int>(j)));
    }
    measures_.rigidSubsets =
        objective::countRigidSubsets(problem_->graph, layout_.table(), beams_.covers(), junctions);
  }
}

double PaperState::objective() {
  return objective::value(measures_, full_ ? weights_ : simpleWeights_);
}

void PaperState::useFullObjective() {
  full_ = true;
  for (std::size_t r = 0; r < problem_->graph.runs.size(); ++r) {
    layout_.setCover(static_cast<int>(r), beams_.cover(static_cast<int>(r)));
  }
  layout_.settleAll();
  layout_.keep();
  measure();
  energy_ = objective();
}

void PaperState::propose() {
  operator_.modify(&beams_, full_ ? kTurnShare : 0.0);
  settle();
}

void PaperState::propose(const CoverChanges& changes) {
  for (const auto& [run, cover] : changes) {
    beams_.setCover(run, cover);
  }
  settle();
}

CoverChanges PaperState::changes() const {
  CoverChanges changes;
  for (const int run : beams_.touched()) {
    changes.emplace_back(run, beams_.cover(run));
  }
  return changes;
}

void PaperState::settle() {
  beams_.settle();
  if (full_) {
    for (const int run : beams_.touched()) {
      layout_.setCover(run, beams_.cover(run));
    }
    layout_.settle();
  }
  if (beams_.turned()) {
    components_ = layout::findComponents(problem_->graph, beams_.covers());
  }
  before_ = measures_;
  measure();
  proposed_ = objective();
}

void PaperState::accept() {
  beams_.keep();
  layout_.keep();
  energy_ = proposed_;
}

void PaperState::reject() {
  const bool turned = beams_.turned();
  beams_.revert();
  layout_.revert();
  measures_ = before_;
  if (turned) {
    components_ = layout::findComponents(problem_->graph, beams_.covers());
  }
}

LayoutSnapshot PaperState::snapshot() const {
  LayoutSnapshot snapshot;
  snapshot.tallies = measures_.tallies;
  snapshot.energy = energy_;
  snapshot.covers = beams_.covers();
  for (std::size_t j = 0; j < problem_->graph.junctions.size(); ++j) {
    snapshot.junctions.push_back(layout_.junction(static_cast<int>(j)));
  }
  return snapshot;
}

}  // namespace liftarm::search
