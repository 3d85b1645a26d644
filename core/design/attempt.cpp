#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

#include "design/alikeness.h"
#include "design/attempt_search.h"
#include "design/looseness.h"
#include "layout/stack.h"
#include "objective/objective.h"
#include "rivals/rivals.h"
#include "search/annealer.h"
#include "search/paper_search.h"
#include "search/tuning.h"

namespace liftarm::design {

namespace {

constexpr std::uint32_t kWishingRounds = 5;  // before a wish is given up
constexpr double kWorthOfSymmetry = 0.25;    // of the objective, of a whole model ...
constexpr double kWorthOfAlikeness = 0.15;   // ... and of a part of it
constexpr double kWorthOfFreedom = search::kTuning.holds.worth;
constexpr double kAlike = 1.0 - 1e-9;
constexpr std::uint32_t kSymmetricRounds = 5;  // that stiffen: more find nothing
constexpr std::uint32_t kFreeingRounds = 9;
// Moves times junctions of all searches, after which nothing is compared with what is whole.
constexpr double kMostWork = 4e6;
constexpr double kUsualLines = 300.0;      // of a sketch; larger ones may take longer ...
constexpr double kUsualLength = 3000.0;    // ... and longer ones: modules
constexpr double kShareOfOneWish = 0.5;    // of the work that is left, before a wish is given up
constexpr std::uint32_t kRoundsOfFew = 4;  // that stiffen, before other hole axes are tried
constexpr std::uint64_t kSeedStep = 0x9E3779B97F4A7C15U;  // far from the seeds that a person tries

mechanisms::MechanismTable makeTable(const Settings& settings) {
  mechanisms::CompositionOptions options;
  std::copy_if(settings.connectors.begin(),
               settings.connectors.end(),
               std::back_inserter(options.partIds),
               [](const std::string& id) { return id != layout::kSpacerPart; });
  options.maxParts = settings.mechanismParts;
  return mechanisms::MechanismTable(
      mechanisms::composeMechanisms(parts::Catalogue::builtIn(), options));
}

//! The paper's method, or one of its rivals.
std::unique_ptr<search::LayoutSearch> makePaperSearch(const Settings& settings,
                                                      const layout::LayoutProblem& problem,
                                                      layout::ConnectionSolver& solver) {
  search::PaperOptions options = settings.paper;
  options.seed = settings.annealing.seed;
  options.corners = settings.annealing.parts.corners;
  options.lengths = settings.annealing.lengths;
  options.weights = settings.annealing.weights;
  if (settings.method == kPaperMethod) {
    return std::make_unique<search::PaperSearch>(problem, solver, std::move(options));
  }
  return rivals::makeRival(settings.method, problem, solver, {std::move(options), settings.effort});
}

//! The paper's method knows no spacers.
bool fillsGaps(const Settings& settings) {
  return !isPaperFamily(settings.method) &&
         std::find(settings.connectors.begin(), settings.connectors.end(), layout::kSpacerPart) !=
             settings.connectors.end();
}

//! Whether one search takes about all the work that there may be.
bool isLarge(const layout::LayoutProblem& problem, const search::AnnealingOptions& options) {
  constexpr double kRounds = 2.5;
  const double moves = options.minIterations + static_cast<double>(options.iterationsPerRun) *
                                                   static_cast<double>(problem.graph.runs.size());
  return kRounds * moves * static_cast<double>(problem.graph.junctions.size()) > 0.5 * kMostWork;
}

}  // namespace

layout::LayoutProblem problemOf(const sketch::Sketch& sketch, const Settings& settings) {
  guide::GuidingGraph graph = guide::buildGuidingGraph(sketch, bridgingOf(settings));
  layout::turnToKeeps(sketch, settings.keeps, &graph);
  layout::LayoutProblem problem = layout::makeLayoutProblem(std::move(graph), fillsGaps(settings));
  layout::addKeeps(sketch, settings.keeps, &problem);
  problem.closeGroups = isPaperFamily(settings.method) && settings.closeGroups;
  return problem;
}

bool isWhole(const search::LayoutSnapshot& layout) {
  return !layout.covers.empty() && layout.tallies.violations() + layout.missing == 0;
}

Attempts::Attempts(const sketch::Sketch& sketch, const Settings& settings)
    : sketch_(&sketch), settings_(&settings), table_(makeTable(settings)) {
  if (settings.symmetric && settings.annealing.earlier.empty() && sketch.symmetries.empty()) {
    symmetries_ = wishedSymmetries(sketch);
  }
  plans_ =
      plansFor({settings.standing && !liesFlat(sketch), !symmetries_.empty()}, symmetries_.size());
  const Wishes first = plans_.back();
  plans_.pop_back();
  begin(first, plans_.empty());
}

Attempts::~Attempts() = default;

void Attempts::begin(Wishes wishes, bool last) {
  current_ = std::make_unique<Attempt>(withWishes(*sketch_, wishes), *settings_, table_);
  Attempt& attempt = *current_;
  attempt.wishes = wishes;
  if (isPaperFamily(settings_->method)) {
    attempt.search = makePaperSearch(*settings_, attempt.problem, attempt.solver);
    return;
  }
  search::AnnealingOptions options = settings_->annealing;
  if (wishes.again) {
    options = optionsAlone(*sketch_, std::move(options), kRoundsAlone);
  } else if (wishes.more > 0) {
    options.seed += (wishes.more - 1) * kSeedStep;
    if (best_ == nullptr) {
      options.minIterations = std::min(options.minIterations, kShortRound);
    }
  }
  if (wishes.few) {
    options.weights = objective::searchWeights(objective::Preset::kSimpleRigid);
    options.stiffening.otherStarts = true;
    options.stiffening.roundsPerStart = kRoundsOfFew;
  }
  if (wishes.settled) {
    options.from = &best_->search->best();
  }
  options.held = makeHeld(attempt.problem, table_);
  if (objective::isRigid(settings_->preset)) {
    objective::Mobility* mobility = &attempt.mobility;
    options.freedoms = [mobility](const search::LayoutSnapshot& layout) {
      return mobility->count(layout.covers, layout.junctions);
    };
    options.looseRuns = [mobility] { return mobility->looseRuns(); };
    options.bodies = [mobility] { return mobility->bodies(); };
  }
  options.buildable = makeBuildable(attempt.problem, table_, *sketch_);
  // Where another search would take too long, this one gives up in itself what keeps it loose.
  const bool alone = wishes.symmetric && isLarge(attempt.problem, options);
  options.stiffening.frees = alone || wishes.mostly;
  if (alone) {
    std::erase_if(plans_, [](Wishes plan) { return plan.mostly || plan.only >= 0; });
  }
  if (wishes.symmetric && !alone) {
    options.stiffening.rounds =
        std::min(options.stiffening.rounds, wishes.mostly ? kFreeingRounds : kSymmetricRounds);
  }
  options.maxRounds =
      last || wishes.again ? options.maxRounds : std::min(options.maxRounds, kWishingRounds);
  options.mostWork = workLeft();
  options.mostWorkUntilWhole = (last || wishes.more > 0 ? 1.0 : kShareOfOneWish) * options.mostWork;
  attempt.search =
      std::make_unique<search::Annealer>(attempt.problem, attempt.solver, std::move(options));
}

double Attempts::workLeft() const {
  double length = 0.0;
  for (const sketch::Line& line : sketch_->lines) {
    length += line.length;
  }
  const double share = std::max(
      {1.0, static_cast<double>(sketch_->lines.size()) / kUsualLines, length / kUsualLength});
  return std::max(0.0, share * settings_->annealing.mostWork - workBefore_);
}

//! What a layout that has ended is worth beside others. Its own energy has freedoms at what they
//! cost in the round that found it.
void Attempts::judge(Attempt* attempt) const {
  const search::LayoutSnapshot& layout = attempt->search->best();
  const double share = alikeness(attempt->problem, layout, symmetries_);
  attempt->alike = share > kAlike;
  const double worth = attempt->alike ? kWorthOfSymmetry : kWorthOfAlikeness * share;
  attempt->freedoms = layout.freedoms;
  if (objective::isRigid(settings_->preset) && !isPaperFamily(settings_->method) &&
      isWhole(layout)) {
    attempt->freedoms =
        std::max(attempt->freedoms, attempt->mobility.count(layout.covers, layout.junctions));
  }
  if (settings_->standing && !isPaperFamily(settings_->method) && isWhole(layout)) {
    attempt->faults = countStandingFaults(attempt->problem, table_, *sketch_, layout);
  }
  objective::Measures measures;
  measures.tallies = layout.tallies;
  measures.scale = objective::scaleOf(attempt->problem.graph);
  // An axle stands for a line as a beam does; whether it may was for its own search to say.
  const objective::Weights& weights = settings_->annealing.weights;
  const double axles = weights[*objective::termIndex("beams")] * layout.tallies.axles;
  attempt->value = (1.0 - worth) * (objective::value(measures, weights) + axles) +
                   kWorthOfFreedom * attempt->freedoms;
}

bool Attempts::advance(std::uint32_t iterations) {
  if (!done_ && current_->search->advance(iterations)) {
    goOn();
  }
  // A search that begins a further round says less than before.
  fraction_ =
      done_ ? 1.0 : std::max(fraction_, 1.0 - left_ * (1.0 - 0.5 * current_->search->fraction()));
  return done_;
}

//! After a search has ended: whether there is an answer, or what comes next.
void Attempts::goOn() {
  judge(current_.get());
  workBefore_ += current_->search->work();
  if (best_ == nullptr && !isPaperFamily(settings_->method) && !isWhole(current_->search->best())) {
    findReason();
  }
  iterationsBefore_ += current_->search->iterations();
  improvementsBefore_ += best_ == nullptr ? current_->search->improvements() : 0;
  if (best_ != nullptr && current_->wishes.more > 0 && current_->faults >= best_->faults &&
      current_->freedoms >= best_->freedoms) {
    betterSeeds_ = kBetterSeeds;  // it is the drawing that makes it so, not the seed
  }
  // One freedom fewer is no reason to be lopsided where something moves all the same.
  const auto rank = [](const Attempt& attempt) {
    return std::tuple(attempt.faults > 0, attempt.freedoms > 0, attempt.value);
  };
  if (isWhole(current_->search->best()) && (best_ == nullptr || rank(*current_) < rank(*best_))) {
    improvementsBefore_ += best_ == nullptr ? 0 : 1;
    best_ = std::move(current_);
    dropNeedlessPlans();
  }
  const double work = static_cast<double>(iterationsBefore_) *
                      static_cast<double>(problem().graph.junctions.size());
  planMoreSeeds();
  planBetterSeed();
  if (best_ != nullptr && (isGoodEnough(*best_) || work > kMostWork)) {
    plans_.clear();
  }
  planOtherPrices();
  done_ = plans_.empty() || crowded_.has_value() || workLeft() <= 0.0;
  if (done_) {
    return;
  }
  left_ *= 0.5;
  const Wishes next = plans_.back();
  plans_.pop_back();
  begin(next, plans_.empty());
}

bool Attempts::done() const {
  return done_;
}

double Attempts::fraction() const {
  return fraction_;
}

std::uint32_t Attempts::improvements() const {
  const bool counted = done_ || best_ != nullptr;
  return improvementsBefore_ + (counted ? 0 : current_->search->improvements());
}

std::uint64_t Attempts::iterations() const {
  return iterationsBefore_ + (done_ ? 0 : current_->search->iterations());
}

const search::LayoutSearch& Attempts::search() const {
  return *shown().search;
}

const layout::LayoutProblem& Attempts::problem() const {
  return shown().problem;
}

int Attempts::freedoms() const {
  return shown().freedoms;
}

//! While another layout is looked for, the best one is what there is.
const Attempts::Attempt& Attempts::shown() const {
  return best_ != nullptr ? *best_ : *current_;
}

}  // namespace liftarm::design
