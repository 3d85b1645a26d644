#include "design/attempt.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "design/covers_in_use.h"
#include "design/looseness.h"
#include "layout/stack.h"
#include "objective/mobility.h"
#include "search/annealer.h"
#include "search/cover_bound.h"
#include "search/paper_search.h"
#include "sketch/symmetry_finder.h"

namespace liftarm::design {

namespace {

constexpr std::uint32_t kWishingRounds = 5;  // before a wish is given up
constexpr double kManyBeams = 1.1;        // of the fewest: then a layout without mirrors is tried
constexpr double kWorthOfSymmetry = 0.9;  // of the objective
constexpr std::size_t kMostRunsToCompare = 120;  // larger sketches would wait too long
constexpr double kHalfBeam = 0.5;                // modules from a beam's middle line to its side
constexpr double kAlong = 1e-6;

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

//! Across X or Y: what a builder sees as left and right, front and back. Diagonal mirrors swap hole
//! axes and contradict those.
bool isSideways(lattice::Vec3 normal) {
  return std::abs(normal.x) > 1.0 - kAlong || std::abs(normal.y) > 1.0 - kAlong;
}

//! The paper's method knows no spacers.
bool fillsGaps(const Settings& settings) {
  return settings.method != kPaperMethod &&
         std::find(settings.connectors.begin(), settings.connectors.end(), layout::kSpacerPart) !=
             settings.connectors.end();
}

bool isWhole(const search::LayoutSnapshot& layout) {
  return !layout.covers.empty() && layout.tallies.violations() + layout.missing == 0;
}

//! What is tried, the first last: all wishes, then to stand alone, then none.
std::vector<Wishes> plansFor(Wishes all) {
  if (all.standing && all.symmetric) {
    return {Wishes{}, Wishes{true, false}, all};
  }
  return all.standing || all.symmetric ? std::vector<Wishes>{Wishes{}, all}
                                       : std::vector<Wishes>{Wishes{}};
}

}  // namespace

//! One search with all that it looks at.
struct Attempts::Attempt {
  Attempt(const sketch::Sketch& wanted,
          const Settings& settings,
          const mechanisms::MechanismTable& table)
      : solver(table, settings.connection),
        problem(layout::makeLayoutProblem(guide::buildGuidingGraph(wanted, bridgingOf(settings)),
                                          fillsGaps(settings))),
        mobility(problem, table) {}

  Wishes wishes;
  layout::ConnectionSolver solver;
  layout::LayoutProblem problem;
  objective::Mobility mobility;
  std::unique_ptr<search::LayoutSearch> search;
};

sketch::Sketch withWishes(const sketch::Sketch& sketch, Wishes wishes) {
  sketch::Sketch wanted = sketch;
  if (wishes.standing && !wanted.ground && !wanted.lines.empty()) {
    double lowest = wanted.lines.front().from.z;
    for (const sketch::Line& line : wanted.lines) {
      lowest = std::min({lowest, line.from.z, line.to.z});
    }
    wanted.ground = lowest - kHalfBeam;
  }
  if (wishes.symmetric && wanted.symmetries.empty()) {
    for (const sketch::Symmetry& found : sketch::findSymmetries(sketch).symmetries) {
      if (found.kind == sketch::Symmetry::Kind::kReflection && found.lines.empty() &&
          isSideways(found.normal)) {
        wanted.symmetries.push_back(found);
      }
    }
  }
  return wanted;
}

Attempts::Attempts(const sketch::Sketch& sketch, const Settings& settings)
    : sketch_(&sketch), settings_(&settings), table_(makeTable(settings)) {
  plans_ = plansFor({settings.standing, settings.symmetric && settings.annealing.earlier.empty()});
  const Wishes first = plans_.back();
  plans_.pop_back();
  begin(first, plans_.empty());
}

Attempts::~Attempts() = default;

void Attempts::begin(Wishes wishes, bool last) {
  current_ = std::make_unique<Attempt>(withWishes(*sketch_, wishes), *settings_, table_);
  Attempt& attempt = *current_;
  attempt.wishes = wishes;
  if (settings_->method == kPaperMethod) {
    search::PaperOptions options = settings_->paper;
    options.seed = settings_->annealing.seed;
    options.corners = settings_->annealing.parts.corners;
    options.lengths = settings_->annealing.lengths;
    options.weights = settings_->annealing.weights;
    attempt.search =
        std::make_unique<search::PaperSearch>(attempt.problem, attempt.solver, std::move(options));
    return;
  }
  search::AnnealingOptions options = settings_->annealing;
  options.held = makeHeld(attempt.problem, table_);
  if (objective::isRigid(settings_->preset)) {
    objective::Mobility* mobility = &attempt.mobility;
    options.freedoms = [mobility](const search::LayoutSnapshot& layout) {
      return mobility->count(layout.covers, layout.junctions);
    };
    options.looseRuns = [mobility] { return mobility->looseRuns(); };
  }
  options.buildable = makeBuildable(attempt.problem, table_, *sketch_);
  options.stiffening.frees = options.stiffening.frees && sketch_->symmetries.empty();
  options.maxRounds = last ? options.maxRounds : std::min(options.maxRounds, kWishingRounds);
  attempt.search =
      std::make_unique<search::Annealer>(attempt.problem, attempt.solver, std::move(options));
}

//! Whether the layout found with the present wishes need not be compared with others.
bool Attempts::isGoodEnough() const {
  const search::LayoutSnapshot& best = current_->search->best();
  if (!isWhole(best)) {
    return false;
  }
  const guide::GuidingGraph& graph = current_->problem.graph;
  if (!current_->wishes.symmetric || !sketch_->symmetries.empty() || graph.symmetries.empty() ||
      graph.runs.size() > kMostRunsToCompare) {
    return true;
  }
  const int bound = search::coverLowerBound(coversInUse(current_->problem, *settings_));
  return best.freedoms == 0 && static_cast<double>(best.tallies.beams + best.tallies.axles) <=
                                   kManyBeams * static_cast<double>(bound);
}

bool Attempts::beats(const Attempt& one, const Attempt& other) const {
  const search::LayoutSnapshot& mine = one.search->best();
  const search::LayoutSnapshot& theirs = other.search->best();
  if (!isWhole(mine) || mine.freedoms != theirs.freedoms) {
    return isWhole(mine) && mine.freedoms < theirs.freedoms;
  }
  return mine.energy < kWorthOfSymmetry * theirs.energy;
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

//! After a search has ended: whether its layout is the answer, or what comes next.
void Attempts::goOn() {
  const bool compared = symmetric_ != nullptr;
  if (compared && beats(*current_, *symmetric_)) {
    improvementsBefore_ += symmetric_->search->improvements();
  } else if (compared) {
    iterationsBefore_ += current_->search->iterations() - symmetric_->search->iterations();
    current_ = std::move(symmetric_);
  }
  done_ = compared || plans_.empty() || isGoodEnough();
  if (done_) {
    symmetric_.reset();
    return;
  }
  iterationsBefore_ += current_->search->iterations();
  left_ *= 0.5;
  if (isWhole(current_->search->best())) {
    symmetric_ = std::move(current_);
  } else {
    improvementsBefore_ += current_->search->improvements();
  }
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
  return improvementsBefore_ + shown().search->improvements();
}

std::uint64_t Attempts::iterations() const {
  return iterationsBefore_ + current_->search->iterations();
}

const search::LayoutSearch& Attempts::search() const {
  return *shown().search;
}

const layout::LayoutProblem& Attempts::problem() const {
  return shown().problem;
}

//! While another layout is looked for, the symmetric one is what there is.
const Attempts::Attempt& Attempts::shown() const {
  return symmetric_ != nullptr ? *symmetric_ : *current_;
}

}  // namespace liftarm::design
