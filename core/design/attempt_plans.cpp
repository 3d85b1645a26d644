#include <algorithm>
#include <utility>

#include "design/attempt_search.h"
#include "design/covers_in_use.h"
#include "design/keep_blame.h"
#include "search/cover_bound.h"

// What comes after a search: others, a reason why there is none, or an end.

namespace liftarm::design {

namespace {

constexpr double kManyBeams = 1.3;  // of the fewest: then a layout without mirrors is tried
constexpr std::size_t kMostRunsToCompare = 120;  // larger sketches would wait too long
constexpr std::size_t kFewestCrowded = 3;  // lines: two can be joined, or their angle is at fault
constexpr std::size_t kMostCrowded = 16;   // lines that are looked at alone
constexpr std::size_t kMostLooks = 4;      // at places alone
constexpr double kRegion = 2.0;            // modules, where no node alone is at fault
constexpr std::uint32_t kMoreSeeds = 3;    // where nothing else is known to help
constexpr std::size_t kMostRunsForMore = 40;
constexpr double kWorkOfBetterSeeds = 1.5e9;  // of all searches before, in nanoseconds about
constexpr double kWorkToCompare = 4e8;        // the same: nobody notices the other plans until then
constexpr double kWorkOfOtherPrices = 5e8;    // of all searches before
constexpr int kOtherPrices = 3;               // searches with them, the last with prices as usual

}  // namespace

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

//! Other prices lead elsewhere: where beams alone count, layouts are found with fewer of them and
//! stiffer ones that the usual search does not come by; what they are worth is judged alike. The
//! best of them is then searched further with prices as they are.
void Attempts::planOtherPrices() {
  if (best_ == nullptr || !settings_->otherPrices || workBefore_ > kWorkOfOtherPrices ||
      !settings_->annealing.earlier.empty()) {
    return;
  }
  while (plans_.empty() && otherPrices_ < kOtherPrices) {
    Wishes wishes = best_->wishes;
    ++otherPrices_;
    if (otherPrices_ == kOtherPrices && wishes.few) {
      wishes.few = false;
      wishes.settled = true;
      plans_.push_back(wishes);
    } else if (otherPrices_ == 1 || (otherPrices_ == 2 && wishes.symmetric)) {
      // Frames and bent beams across a mirror obey no symmetry, and may be symmetric all the same.
      wishes.symmetric = wishes.symmetric && otherPrices_ == 1;
      wishes.mostly = wishes.mostly && wishes.symmetric;
      wishes.only = wishes.symmetric ? wishes.only : -1;
      wishes.few = true;
      plans_.push_back(wishes);
    }
  }
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

//! What stands is not compared with what need not; where nothing is loose, nothing is to be freed.
void Attempts::dropNeedlessPlans() {
  std::erase_if(plans_, [&](Wishes plan) { return plan.standing < best_->wishes.standing; });
  if (best_->wishes.symmetric && best_->freedoms == 0) {
    std::erase_if(plans_, [](Wishes plan) { return plan.mostly; });
  }
}

}  // namespace liftarm::design
