#include "analysis/disassembly.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>

#include "analysis/assembly_order.h"
#include "analysis/disassembly_moves.h"
#include "analysis/disassembly_state.h"
#include "base/index.h"

namespace liftarm::analysis {

namespace {

using base::at;
using lattice::Vec3;
using parts::PartClass;

// A subassembly of so many parts is taken off before a single part is drawn out on two legs.
constexpr std::size_t kSmallSet = 6;

// Sets that leave the rest in one piece are looked for among so many parts at most.
constexpr std::size_t kFewParts = 200;

bool isFastener(const Scene& scene, int part) {
  const PartClass c = scene.parts[at(part)].part->partClass;
  return c == PartClass::kPin || c == PartClass::kAxle || c == PartClass::kBush;
}

//! Takes one connected set after another apart.
class Planner {
 public:
  Planner(const Scene& scene, const DisassemblyWishes& wishes)
      : graphs_(scene), wishes_(wishes), unitOf_(scene.parts.size(), -1) {
    for (std::size_t u = 0; u < wishes.units.size(); ++u) {
      for (const int part : wishes.units[u]) {
        unitOf_[at(part)] = static_cast<int>(u);
      }
    }
  }

  DisassemblyPlan run() {
    std::vector<int> all;
    for (std::size_t i = 0; i < graphs_.scene.parts.size(); ++i) {
      if (graphs_.scene.parts[i].part != nullptr) {
        all.push_back(static_cast<int>(i));
      }
    }
    plan_.groups.push_back({std::move(all), {}});
    for (std::size_t g = 0; g < plan_.groups.size(); ++g) {
      takeApart(g);
    }
    if (wishes_.upwards) {
      buildUpwards(graphs_, wishes_, plan_.groups.front());
    }
    return std::move(plan_);
  }

 private:
  struct Candidate {
    int part = -1;
    bool cut = false;
  };

  void takeApart(std::size_t g) {
    DisassemblyState state(graphs_.blocking, graphs_.neighbours, plan_.groups[g].parts);
    last_ = -1;
    inWhole_ = g == 0;
    while (state.parts().size() > 1) {
      if (state.parts().size() < plan_.groups[g].parts.size() && isUnit(state.parts())) {
        addRemoval({state.parts(), {}, -1, false}, g);
        return;
      }
      Removal removal = next(state);
      if (removal.parts.empty()) {
        removal = force(state);
      } else if (wishes_.holdTogether) {
        Removal larger = leaving(state, state.withLoose(removal.parts));
        removal = larger.parts.size() > removal.parts.size() ? std::move(larger) : removal;
      }
      state.remove(removal.parts);
      last_ = removal.parts.front();
      addRemoval(std::move(removal), g);
    }
    if (!state.parts().empty()) {
      plan_.groups[g].removals.push_back({state.parts(), {}, -1, false});
    }
  }

  void addRemoval(Removal removal, std::size_t g) {
    if (removal.parts.size() > 1) {
      removal.group = static_cast<int>(plan_.groups.size());
      plan_.groups.push_back({removal.parts, {}});
    }
    plan_.groups[g].removals.push_back(std::move(removal));
  }

  [[nodiscard]] bool isUnit(const std::vector<int>& parts) const {
    const int unit = unitOf_[at(parts.front())];
    return unit >= 0 && wishes_.units[at(unit)] == parts;
  }

  [[nodiscard]] Removal next(const DisassemblyState& state) const {
    const std::vector<Candidate> singles = findSingles(state);
    Removal removal = leavingComponent(state);
    if (removal.parts.empty()) {
      removal = leavingUnit(state);
    }
    if (removal.parts.empty()) {
      removal = leavingSingle(state, singles, true);
    }
    if (removal.parts.empty()) {
      removal = leavingSingle(state, singles, false);
    }
    if (removal.parts.empty()) {
      removal = leavingSide(state, singles);
    }
    if (removal.parts.empty() && !singles.empty()) {
      removal = leavingSet(state);
    }
    if (removal.parts.empty() && !singles.empty()) {
      removal = leaving(state, {singles.front().part});
    }
    return removal.parts.empty() ? nextOfLocked(state) : removal;
  }

  //! Nothing leaves alone in one move.
  [[nodiscard]] Removal nextOfLocked(const DisassemblyState& state) const {
    const std::vector<std::vector<int>> sets = findSets(state);
    if (!sets.empty() && sets.front().size() <= kSmallSet) {
      return leaving(state, sets.front());
    }
    for (const int part : byOrder(state)) {
      std::vector<Vec3> legs = findRetraction(graphs_, state, {part});
      if (!legs.empty()) {
        return {{part}, std::move(legs), -1, false};
      }
    }
    return sets.empty() ? Removal{} : leaving(state, sets.front());
  }

  [[nodiscard]] Removal leaving(const DisassemblyState& state, const std::vector<int>& set) const {
    const std::optional<int> direction = findWayOut(graphs_, state, set);
    if (!direction.has_value()) {
      return {};
    }
    return {set, {clearingLeg(graphs_, state, set, *direction)}, -1, false};
  }

  //! Smaller leaves first: fasteners that hold nothing any more, high parts, fasteners, what is
  //! near the last one.
  using Key = std::tuple<bool, int, double, bool, double, int>;

  [[nodiscard]] Key keyOf(const DisassemblyState& state, int part, bool cut) const {
    const Scene& scene = graphs_.scene;
    const bool fastener = isFastener(scene, part);
    const std::vector<int>& holders = graphs_.neighbours[at(part)];
    const bool idle = fastener && std::count_if(holders.begin(), holders.end(), [&](int other) {
                                    return state.has(other);
                                  }) <= 1;
    const double level = std::floor(2.0 * scene.parts[at(part)].box.min.z + 0.5);
    double way = 0.0;
    if (last_ >= 0) {
      const Vec3 offset =
          scene.model->parts[at(part)].pose.position - scene.model->parts[at(last_)].pose.position;
      way = std::floor(lattice::length(offset) * 64.0 + 0.5);
    }
    return {cut, idle ? 0 : 1, -level, !fastener, way, part};
  }

  [[nodiscard]] std::vector<int> byOrder(const DisassemblyState& state) const {
    std::vector<Key> keys;
    for (const int part : state.parts()) {
      keys.push_back(keyOf(state, part, false));
    }
    std::sort(keys.begin(), keys.end());
    std::vector<int> parts;
    for (const Key& key : keys) {
      parts.push_back(std::get<5>(key));
    }
    return parts;
  }

  //! Parts that can leave alone, the best first; those that divide the rest come last.
  [[nodiscard]] std::vector<Candidate> findSingles(const DisassemblyState& state) const {
    const std::vector<char> cut = state.cutParts();
    std::vector<Key> keys;
    for (const int part : state.parts()) {
      for (std::size_t d = 0; d < graphs_.blocking.directions().size(); ++d) {
        if (state.blockerCount(static_cast<int>(d), part) == 0) {
          keys.push_back(keyOf(state, part, cut[at(part)] != 0));
          break;
        }
      }
    }
    std::sort(keys.begin(), keys.end());
    std::vector<Candidate> found;
    for (const Key& key : keys) {
      found.push_back({std::get<5>(key), std::get<0>(key)});
    }
    return found;
  }

  //! \param sparing Leaves the parts of units that are still whole.
  [[nodiscard]] Removal leavingSingle(const DisassemblyState& state,
                                      const std::vector<Candidate>& singles,
                                      bool sparing) const {
    std::vector<int> fit;
    for (const Candidate& candidate : singles) {
      if (!candidate.cut && !(sparing && inWholeUnit(state, candidate.part))) {
        fit.push_back(candidate.part);
      }
    }
    return fit.empty() ? Removal{} : leaving(state, {steadiest(state, fit)});
  }

  //! The first of the next few parts that leaves the whole standing; else the first.
  [[nodiscard]] int steadiest(const DisassemblyState& state, const std::vector<int>& parts) const {
    constexpr std::size_t kTries = 8;
    if (!wishes_.stands || !inWhole_) {
      return parts.front();
    }
    for (std::size_t i = 0; i < std::min(parts.size(), kTries); ++i) {
      if (wishes_.stands(state.others({parts[i]}))) {
        return parts[i];
      }
    }
    return parts.front();
  }

  [[nodiscard]] bool isWhole(const DisassemblyState& state, const std::vector<int>& unit) const {
    return unit.size() < state.parts().size() &&
           std::all_of(unit.begin(), unit.end(), [&](int part) { return state.has(part); });
  }

  [[nodiscard]] bool inWholeUnit(const DisassemblyState& state, int part) const {
    const int unit = unitOf_[at(part)];
    return unit >= 0 && isWhole(state, wishes_.units[at(unit)]);
  }

  //! A unit whose leaving does not divide the rest.
  [[nodiscard]] Removal leavingUnit(const DisassemblyState& state) const {
    for (const std::vector<int>& unit : wishes_.units) {
      if (isWhole(state, unit) && state.connected(state.others(unit))) {
        Removal removal = leaving(state, unit);
        if (!removal.parts.empty()) {
          return removal;
        }
      }
    }
    return {};
  }

  //! Where the parts hang together no more: the smallest piece that can leave as a whole.
  [[nodiscard]] Removal leavingComponent(const DisassemblyState& state) const {
    std::vector<std::vector<int>> pieces = state.components();
    if (pieces.size() < 2) {
      return {};
    }
    sortBySize(pieces);
    for (const std::vector<int>& piece : pieces) {
      Removal removal = leaving(state, piece);
      if (!removal.parts.empty()) {
        return removal;
      }
    }
    return {};
  }

  //! One side of a part whose leaving divides the rest, with it or without.
  [[nodiscard]] Removal leavingSide(const DisassemblyState& state,
                                    const std::vector<Candidate>& singles) const {
    for (const Candidate& candidate : singles) {
      std::vector<std::vector<int>> sides = state.componentsWithout({candidate.part});
      sortBySize(sides);
      for (const std::vector<int>& side : sides) {
        if (2 * side.size() > state.parts().size()) {
          continue;
        }
        std::vector<int> with = side;
        with.insert(std::lower_bound(with.begin(), with.end(), candidate.part), candidate.part);
        for (const std::vector<int>& set : {side, with}) {
          Removal removal = state.connected(set) && state.connected(state.others(set))
                                ? leaving(state, set)
                                : Removal{};
          if (!removal.parts.empty()) {
            return removal;
          }
        }
      }
    }
    return {};
  }

  //! Every part that can leave alone divides the rest: a set that does not, if the parts are few
  //! enough to look for it.
  [[nodiscard]] Removal leavingSet(const DisassemblyState& state) const {
    if (state.parts().size() > kFewParts) {
      return {};
    }
    for (const std::vector<int>& set : state.setsThatDivideNothing()) {
      Removal removal = leaving(state, set);
      if (!removal.parts.empty()) {
        return removal;
      }
    }
    return {};
  }

  static void sortBySize(std::vector<std::vector<int>>& sets) {
    std::stable_sort(
        sets.begin(), sets.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
  }

  //! Connected sets that can leave as a whole, the smallest first.
  [[nodiscard]] std::vector<std::vector<int>> findSets(const DisassemblyState& state) const {
    std::vector<std::vector<int>> sets;
    const auto offer = [&](std::vector<int> set) {
      if (2 * set.size() > state.parts().size()) {
        set = state.others(set);  // what stays leaves the other way
      }
      if (!set.empty() && state.connected(set)) {
        sets.push_back(std::move(set));
      }
    };
    for (std::size_t d = 0; d < graphs_.blocking.directions().size(); ++d) {
      for (std::vector<int>& set : state.lockedSets(static_cast<int>(d))) {
        offer(std::move(set));
      }
    }
    for (std::size_t d = 0; sets.empty() && d < graphs_.blocking.directions().size(); ++d) {
      for (std::vector<int>& set : state.closures(static_cast<int>(d))) {
        if (set.size() < state.parts().size()) {
          offer(std::move(set));
        }
      }
    }
    sortBySize(sets);
    return sets;
  }

  //! Tells the part with the fewest others in its way as stuck, and takes it off all the same.
  Removal force(const DisassemblyState& state) {
    int best = -1;
    int way = 0;
    for (const int part : byOrder(state)) {
      for (std::size_t d = 0; d < graphs_.blocking.directions().size(); ++d) {
        const int direction = static_cast<int>(d);
        if (best < 0 || state.blockerCount(direction, part) < state.blockerCount(way, best)) {
          best = part;
          way = direction;
        }
      }
    }
    StuckParts stuck;
    stuck.parts = {best};
    for (const int blocker : graphs_.blocking.blockers(way, best)) {
      if (state.has(blocker)) {
        stuck.by.push_back(blocker);
      }
    }
    stuck.message =
        nameOf(graphs_.scene, best) + " cannot leave the " + std::to_string(state.parts().size()) +
        " parts that are locked together: at the least, " +
        nameOf(graphs_.scene, stuck.by.front()) +
        (stuck.by.size() > 1 ? " and " + std::to_string(stuck.by.size() - 1) + " more parts are"
                             : " is") +
        " in its way";
    plan_.stuck.push_back(std::move(stuck));
    return {{best}, {clearingLeg(graphs_, state, {best}, way)}, -1, true};
  }

  DisassemblyGraphs graphs_;
  const DisassemblyWishes& wishes_;
  std::vector<int> unitOf_;
  DisassemblyPlan plan_;
  int last_ = -1;
  bool inWhole_ = true;
};

}  // namespace

DisassemblyPlan planDisassembly(const Scene& scene, const DisassemblyWishes& wishes) {
  return Planner(scene, wishes).run();
}

}  // namespace liftarm::analysis
