#include "search/phase_holds.h"

#include <algorithm>

#include "base/index.h"
#include "search/tuning.h"

namespace liftarm::search {

namespace {

using base::at;

constexpr const HoldTuning& kHolds = kTuning.holds;

}  // namespace

Next FurtherHolds::begin() {
  const AnnealingOptions& options = state().options();
  if (!options.freedoms || !options.bodies || !state().hasWhole()) {
    return EndOfSearch{};
  }
  state().setFreedoms(0);
  state().setFreedomCost(0.0);
  state().forgetGrudges();
  state().restore(state().best());
  while (improve()) {
  }
  return EndOfSearch{};
}

//! What fits anywhere and leaves fewer freedoms, what saves most first.
//! \pre The layout is the one that `freedoms` was asked of last.
std::vector<FurtherHolds::Hold> FurtherHolds::find() {
  const std::vector<std::vector<int>> bodies = state().options().bodies();
  std::vector<Hold> all;
  for (std::size_t j = 0; j < state().graph().junctions.size(); ++j) {
    const auto junction = static_cast<int>(j);
    for (const layout::FurtherJoin& join :
         state().layout().furtherJoins(junction, bodies, kHolds.mostEach)) {
      all.push_back({junction, join, 0});
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const Hold& a, const Hold& b) {
    return a.join.cost < b.join.cost;
  });
  LayoutSnapshot layout = state().snapshot();
  std::vector<Hold> found;
  double least = 0.0;  // what the best so far saves
  for (Hold& hold : all) {
    // Nothing that is dearer can save more than this.
    if (kHolds.worth * freedoms_ - hold.join.cost <= least || found.size() >= kHolds.enough) {
      break;
    }
    std::vector<layout::PlacedMechanism>& there =
        layout.junctions[at(hold.junction)].connection.mechanisms;
    there.push_back(hold.join.placed);
    if (!ask(layout, &hold)) {
      break;
    }
    there.pop_back();
    const double saved = savedBy(hold);
    if (saved > 0.0) {
      least = std::max(least, saved);
      found.push_back(hold);
    }
  }
  std::stable_sort(found.begin(), found.end(), [this](const Hold& a, const Hold& b) {
    return savedBy(a) > savedBy(b);
  });
  return found;
}

//! Counts the freedoms of a layout with a hold, as long as that takes no longer than all may take.
bool FurtherHolds::ask(const LayoutSnapshot& layout, Hold* hold) {
  work_ += static_cast<double>(layout.tallies.beams + layout.tallies.connectors);
  if (work_ > kHolds.mostWork) {
    return false;
  }
  hold->freedoms = state().options().freedoms(layout);
  return true;
}

double FurtherHolds::savedBy(const Hold& hold) const {
  return kHolds.worth * (freedoms_ - hold.freedoms) - hold.join.cost;
}

//! Adds what helps, all at once where that can be built, or else one that can.
bool FurtherHolds::improve() {
  freedoms_ = state().options().freedoms(state().best());
  const std::vector<Hold> found = freedoms_ > 0 ? find() : std::vector<Hold>{};
  if (found.empty()) {
    return false;
  }
  addAll(found);
  if (accept()) {
    return true;
  }
  for (std::size_t i = 0; i < found.size() && checks_ < kHolds.mostChecks; ++i) {
    state().restore(state().best());
    state().layout().addMechanism(found[i].junction, found[i].join);
    freedoms_ = found[i].freedoms;
    if (accept()) {
      return true;
    }
  }
  return false;
}

//! Adds the first, and of the others those that still fit and still help.
void FurtherHolds::addAll(const std::vector<Hold>& found) {
  const AnnealingOptions& options = state().options();
  for (const Hold& hold : found) {
    if (freedoms_ == 0) {
      return;
    }
    LayoutSnapshot with = state().snapshot();
    if (&hold != &found.front()) {
      options.freedoms(with);
      const std::vector<layout::FurtherJoin> joins =
          state().layout().furtherJoins(hold.junction, options.bodies(), kHolds.mostEach);
      if (std::none_of(joins.begin(), joins.end(), [&](const layout::FurtherJoin& join) {
            return join.placed.oriented == hold.join.placed.oriented &&
                   join.placed.at == hold.join.placed.at;
          })) {
        continue;
      }
    }
    with.junctions[at(hold.junction)].connection.mechanisms.push_back(hold.join.placed);
    Hold now = hold;
    if (!ask(with, &now)) {
      return;
    }
    if (savedBy(now) > 0.0) {
      state().layout().addMechanism(hold.junction, hold.join);
      freedoms_ = now.freedoms;
    }
  }
}

//! Takes the layout for the best where it lacks nothing and can be built.
bool FurtherHolds::accept() {
  ++checks_;
  state().accept();
  LayoutSnapshot candidate = state().snapshot();
  candidate.missing = state().missing();
  candidate.freedoms = freedoms_;
  candidate.energy = state().best().energy + state().judge().soft(candidate.tallies) -
                     state().judge().soft(state().best().tallies);
  if (!candidate.faultless() || !state().isBuildable(candidate)) {
    return false;
  }
  state().setBest(std::move(candidate));
  return true;
}

}  // namespace liftarm::search
