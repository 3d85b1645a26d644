#include "design/attempt.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

#include "design/alikeness.h"
#include "design/covers_in_use.h"
#include "design/keep_blame.h"
#include "design/looseness.h"
#include "layout/stack.h"
#include "objective/mobility.h"
#include "objective/objective.h"
#include "rivals/rivals.h"
#include "search/annealer.h"
#include "search/cover_bound.h"
#include "search/paper_search.h"
#include "sketch/arrangement.h"

namespace liftarm::design {

namespace {

constexpr std::uint32_t kWishingRounds = 5;  // before a wish is given up
constexpr double kManyBeams = 1.3;          // of the fewest: then a layout without mirrors is tried
constexpr double kWorthOfSymmetry = 0.25;   // of the objective, of a whole model ...
constexpr double kWorthOfAlikeness = 0.15;  // ... and of a part of it
constexpr double kWorthOfFreedom = 20.0;    // two beams, where something moves all the same
constexpr double kAlike = 1.0 - 1e-9;
constexpr std::uint32_t kSymmetricRounds = 5;  // that stiffen: more find nothing
constexpr std::uint32_t kFreeingRounds = 9;
// Moves times junctions of all searches, after which nothing is compared with what is whole.
constexpr double kMostWork = 4e6;
constexpr std::size_t kMostRunsToCompare = 120;  // larger sketches would wait too long
constexpr double kUsualLines = 300.0;            // of a sketch; larger ones may take longer ...
constexpr double kUsualLength = 3000.0;          // ... and longer ones: modules
constexpr double kShareOfOneWish = 0.5;    // of the work that is left, before a wish is given up
constexpr std::size_t kFewestCrowded = 3;  // lines: two can be joined, or their angle is at fault
constexpr std::size_t kMostCrowded = 16;   // lines that are looked at alone
constexpr std::size_t kMostLooks = 4;      // at places alone
constexpr double kRegion = 2.0;            // modules, where no node alone is at fault
constexpr std::uint32_t kMoreSeeds = 3;    // where nothing else is known to help
constexpr std::size_t kMostRunsForMore = 40;
constexpr std::uint32_t kBetterSeeds = 3;     // where what was found is not what a builder builds
constexpr double kWorkOfBetterSeeds = 1.5e9;  // of all searches before, in nanoseconds about
constexpr double kWorkToCompare = 4e8;        // the same: nobody notices the other plans until then
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

//! One search with all that it looks at.
struct Attempts::Attempt {
  Attempt(const sketch::Sketch& wanted,
          const Settings& settings,
          const mechanisms::MechanismTable& table)
      : solver(table, settings.connection),
        problem(problemOf(wanted, settings)),
        mobility(problem, table) {}

  Wishes wishes;
  double value = 0.0;  // of its best layout, with what being symmetric is worth taken off
  bool alike = false;  // whether that layout is symmetric
  int faults = 0;      // of how its model stands, where it is to stand
  int freedoms = 0;    // of that layout, also where the search ended before it asked
  layout::ConnectionSolver solver;
  layout::LayoutProblem problem;
  objective::Mobility mobility;
  std::unique_ptr<search::LayoutSearch> search;
};

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
  options.held = makeHeld(attempt.problem, table_);
  if (objective::isRigid(settings_->preset)) {
    objective::Mobility* mobility = &attempt.mobility;
    options.freedoms = [mobility](const search::LayoutSnapshot& layout) {
      return mobility->count(layout.covers, layout.junctions);
    };
    options.looseRuns = [mobility] { return mobility->looseRuns(); };
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

void Attempts::lookAt(const std::vector<lattice::Vec3>& places, double radius, std::size_t fewest) {
  for (const lattice::Vec3 at : places) {
    const bool known = std::any_of(looked_.begin(), looked_.end(), [&](const auto& looked) {
      return looked.first == radius && lattice::length(looked.second - at) < sketch::kSamePoint;
    });
    const std::size_t lines = linesNear(*sketch_, at, radius).size();
    if (crowded_ || looked_.size() >= kMostLooks || known || lines < fewest ||
        lines > kMostCrowded) {
      continue;
    }
    crowded_ = findCrowded(*sketch_, at, radius, *settings_, table_);
    looked_.emplace_back(radius, at);
    wholeAlone_ = wholeAlone_ || (!crowded_ && lines == sketch_->lines.size());
  }
}

//! Why the search that has ended is not whole: what the sketch keeps, once it is all that is left
//! to ask of it, or the lines at a place.
void Attempts::findReason() {
  if (!settings_->keeps.empty()) {
    if (!plans_.empty() || moreSeeds_ > 0 || settings_->annealing.maxRounds < kRoundsOfBlame) {
      return;
    }
    const search::LayoutSnapshot& failed = current_->search->best();
    blamed_ = findBlame(*sketch_, current_->problem, failed, *settings_, table_);
  }
  if (!blamed_) {
    findCrowdedPlace();
  }
}

//! Looks at the worst nodes of a layout that is not whole, each alone, then at what is near them.
void Attempts::findCrowdedPlace() {
  const search::LayoutSnapshot& best = current_->search->best();
  const guide::GuidingGraph& graph = current_->problem.graph;
  std::vector<lattice::Vec3> places = violatedPlaces(graph, best);
  std::optional<std::size_t> busiest;
  for (std::size_t j = 0; j < best.junctions.size(); ++j) {
    const auto runsAt = [&](std::size_t i) { return graph.junctions[i].incident.size(); };
    busiest = !busiest || runsAt(j) > runsAt(*busiest) ? j : *busiest;
  }
  lookAt(places, 0.0, kFewestCrowded);
  if (!crowded_ && busiest) {
    // Beams may collide beside a node that is joined all right.
    places.push_back(graph.nodes[static_cast<std::size_t>(graph.junctions[*busiest].node)]);
    lookAt(places, kRegion, kFewestCrowded);
  }
}

//! Where every plan failed and no place is known to be at fault, or a look has found a layout of
//! all lines, other seeds and short rounds may find what is there.
void Attempts::planMoreSeeds() {
  if ((plans_.empty() || wholeAlone_) && !blamed_ && best_ == nullptr && moreSeeds_ < kMoreSeeds &&
      !isPaperFamily(settings_->method) &&
      current_->problem.graph.runs.size() <= kMostRunsForMore) {
    plans_.emplace_back();
    plans_.back().more = ++moreSeeds_;
    plans_.back().again = std::exchange(wholeAlone_, false);
  }
}

//! A layout that was found without the wish to stand, and does not or is loose, is compared with
//! one that has it, then with other seeds while they find something better and nobody waits for it.
void Attempts::planBetterSeed() {
  const bool differs =
      betterSeeds_ > 0 || (best_ != nullptr && best_->wishes.standing != settings_->standing);
  if (plans_.empty() && best_ != nullptr && differs && (best_->faults > 0 || best_->freedoms > 0) &&
      betterSeeds_ < kBetterSeeds && workBefore_ < kWorkOfBetterSeeds &&
      settings_->annealing.earlier.empty()) {
    plans_.push_back(best_->wishes);
    plans_.back().standing = settings_->standing;
    plans_.back().more = ++betterSeeds_;
  }
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
  attempt->value = (1.0 - worth) * objective::value(measures, settings_->annealing.weights) +
                   kWorthOfFreedom * attempt->freedoms;
}

//! Whether a layout need not be compared with others.
bool Attempts::isGoodEnough(const Attempt& attempt) const {
  const search::LayoutSnapshot& layout = attempt.search->best();
  if (!isWhole(layout) || attempt.faults > 0 || (!plans_.empty() && workBefore_ < kWorkToCompare)) {
    return false;
  }
  if (attempt.problem.graph.runs.size() > kMostRunsToCompare) {
    return true;
  }
  if (symmetries_.empty()) {
    return attempt.freedoms == 0;
  }
  const int bound = search::coverLowerBound(coversInUse(attempt.problem, *settings_));
  return attempt.freedoms == 0 && (attempt.alike || attempt.wishes.mostly) &&
         static_cast<double>(layout.tallies.beams + layout.tallies.axles) <=
             kManyBeams * static_cast<double>(bound);
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
  done_ = plans_.empty() || crowded_.has_value() || workLeft() <= 0.0 ||
          (best_ != nullptr && (isGoodEnough(*best_) || work > kMostWork));
  if (done_) {
    return;
  }
  left_ *= 0.5;
  const Wishes next = plans_.back();
  plans_.pop_back();
  begin(next, plans_.empty());
}

//! What stands is not compared with what need not; where nothing is loose, nothing is to be freed.
void Attempts::dropNeedlessPlans() {
  std::erase_if(plans_, [&](Wishes plan) { return plan.standing < best_->wishes.standing; });
  if (best_->wishes.symmetric && best_->freedoms == 0) {
    std::erase_if(plans_, [](Wishes plan) { return plan.mostly; });
  }
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
