#include "analysis/assembly_order.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>

#include "analysis/assembly_downwards.h"
#include "analysis/assembly_units.h"
#include "analysis/disassembly_state.h"
#include "base/index.h"

namespace liftarm::analysis {

namespace {

using base::at;
using lattice::Vec3;

// More are left in the order in which they are: the work grows with their square.
constexpr std::size_t kMaxUnits = 600;

constexpr std::size_t kBeginnings = 12;
constexpr std::size_t kManyUnits = 200;

// Of the next few things, one with which it stands is taken.
constexpr std::size_t kLookAhead = 4;

// Lower than what is there by so much, modules, it is built downwards.
constexpr double kLower = 0.6;

//! What speaks against an order: less is better.
struct Faults {
  int hanging = 0;    //!< times that something is held by nothing, and lies not on the table either
  int loose = 0;      //!< times that something is held by nothing
  int downwards = 0;  //!< times that something comes below all that is there, or first above it
  int falling = 0;    //!< times that it rests on no side
  double start = -1.0;  //!< of the first beam above the lowest, modules

  [[nodiscard]] bool operator<(const Faults& other) const {
    return std::tuple(hanging, loose + downwards, falling, start) <
           std::tuple(other.hanging, other.loose + other.downwards, other.falling, other.start);
  }
};

class Ordering {
 public:
  Ordering(const DisassemblyGraphs& graphs,
           const DisassemblyWishes& wishes,
           const std::vector<Removal>& removals)
      : graphs_(graphs), wishes_(wishes), units_(assemblyUnits(graphs, removals)) {
    for (const AssemblyUnit& unit : units_) {
      floor_ = std::min(floor_, unit.floor);
    }
  }

  //! The new order of removals, or nothing if the old one is as good.
  [[nodiscard]] std::optional<std::vector<Removal>> better() const {
    std::vector<int> old(units_.size());
    for (std::size_t u = 0; u < old.size(); ++u) {
      old[u] = static_cast<int>(u);
    }
    std::vector<int> best = old;
    Faults least = faultsOf(old);
    std::vector<std::vector<int>> orders{orderDownwards(units_)};
    for (const int first : beginnings()) {
      orders.push_back(orderFrom(first));
    }
    for (std::vector<int>& order : orders) {
      if (order.size() == units_.size()) {
        if (const Faults faults = faultsOf(order); faults < least) {
          least = faults;
          best = std::move(order);
        }
      }
    }
    return best == old ? std::nullopt : removalsOf(best);
  }

 private:
  //! Single parts, the lowest first.
  [[nodiscard]] std::vector<int> beginnings() const {
    std::vector<int> found;
    for (std::size_t u = 0; u < units_.size(); ++u) {
      if (!units_[u].fastener && units_[u].removal.parts.size() == 1) {
        found.push_back(static_cast<int>(u));
      }
    }
    std::stable_sort(found.begin(), found.end(), [&](int a, int b) {
      return units_[at(a)].floor < units_[at(b)].floor - 1e-6;
    });
    const std::size_t most = units_.size() > kManyUnits ? kBeginnings / 4 : kBeginnings;
    found.resize(std::min(found.size(), most));
    return found;
  }

  //! What is there, and how the rest can still come in.
  struct Built {
    std::vector<int> order;
    std::vector<char> has;  //!< by unit
    std::vector<int> parts;
    std::vector<std::uint16_t> blocked;  //!< by unit and direction, how many are in its way
    std::vector<std::uint16_t> ways;     //!< by unit, directions in which none is
  };

  [[nodiscard]] Built nothing() const {
    const std::size_t directions = graphs_.blocking.directions().size();
    const auto all = static_cast<std::uint16_t>(directions);
    return {{},
            std::vector<char>(units_.size(), 0),
            {},
            std::vector<std::uint16_t>(units_.size() * directions, 0),
            std::vector<std::uint16_t>(units_.size(), all)};
  }

  //! \return Units that could not come in any more.
  std::vector<int> put(Built& built, int u) const {
    std::vector<int> shut;
    built.order.push_back(u);
    built.has[at(u)] = 1;
    const std::vector<int>& parts = units_[at(u)].removal.parts;
    built.parts.insert(built.parts.end(), parts.begin(), parts.end());
    const std::size_t directions = graphs_.blocking.directions().size();
    for (std::size_t d = 0; d < directions; ++d) {
      // Directions come in opposite pairs: what u hits along one is hit by it along the other.
      for (const int other : units_[at(u)].hits[d ^ 1U]) {
        if (built.has[at(other)] == 0 && built.blocked[at(other) * directions + d]++ == 0 &&
            --built.ways[at(other)] == 0) {
          shut.push_back(other);
        }
      }
    }
    return shut;
  }

  //! Puts a unit in if all others can still come after it.
  bool tryPut(Built& built, int u) const {
    if (built.has[at(u)] != 0 || built.ways[at(u)] == 0) {
      return false;
    }
    Built then = built;
    if (!put(then, u).empty()) {
      return false;
    }
    built = std::move(then);
    return true;
  }

  //! The same, where pins of it that could not come after it come before it.
  bool tryPutWithPins(Built& built, int u) const {
    if (tryPut(built, u)) {
      return true;
    }
    Built then = built;
    const std::vector<int> shut = put(then, u);
    then = built;
    for (const int pin : shut) {
      if (!isPinOf(pin, units_[at(u)]) || !tryPut(then, pin)) {
        return false;
      }
    }
    if (shut.empty() || !tryPut(then, u)) {
      return false;
    }
    built = std::move(then);
    return true;
  }

  [[nodiscard]] bool isPinOf(int pin, const AssemblyUnit& unit) const {
    return units_[at(pin)].fastener &&
           std::binary_search(unit.touches.begin(), unit.touches.end(), pin);
  }

  static bool anyOf(const std::vector<int>& units, const std::vector<char>& in) {
    return std::any_of(units.begin(), units.end(), [&](int u) { return in[at(u)] != 0; });
  }

  static bool allOf(const std::vector<int>& units, const std::vector<char>& in) {
    return std::all_of(units.begin(), units.end(), [&](int u) { return in[at(u)] != 0; });
  }

  //! Pins that fix a unit to what was built before it, as far as they can come now.
  void putPinsBetween(Built& then, const Built& built, const AssemblyUnit& unit) const {
    for (const int pin : unit.touches) {
      if (units_[at(pin)].fastener && anyOf(units_[at(pin)].touches, built.has)) {
        tryPut(then, pin);
      }
    }
  }

  //! \return What is there with this unit and its pins; nothing if it must wait or touches nothing.
  [[nodiscard]] std::optional<Built> with(const Built& built, int u) const {
    const AssemblyUnit& unit = units_[at(u)];
    Built then = built;
    putPinsBetween(then, built, unit);
    if (!tryPutWithPins(then, u)) {
      return std::nullopt;
    }
    putPinsBetween(then, built, unit);
    const bool touching = std::any_of(unit.touches.begin(), unit.touches.end(), [&](int other) {
      return built.has[at(other)] != 0 ||
             (then.has[at(other)] != 0 && anyOf(units_[at(other)].touches, built.has));
    });
    return touching ? std::optional(std::move(then)) : std::nullopt;
  }

  //! The lowest unit that can come next, the nearest of these; of the first few, one that stands.
  [[nodiscard]] std::optional<Built> next(const Built& built) const {
    using Key = std::tuple<double, double, int>;
    std::vector<Key> keys;
    const Vec3 last = units_[at(built.order.back())].middle;
    for (std::size_t u = 0; u < units_.size(); ++u) {
      if (built.has[u] == 0 && !units_[u].fastener) {
        keys.emplace_back(std::floor(2.0 * units_[u].floor + 0.5),
                          std::floor(64.0 * lattice::length(units_[u].middle - last) + 0.5),
                          static_cast<int>(u));
      }
    }
    std::sort(keys.begin(), keys.end());
    std::optional<Built> first;
    std::size_t found = 0;
    for (const Key& key : keys) {
      std::optional<Built> then = with(built, std::get<2>(key));
      if (!then.has_value()) {
        continue;
      }
      if (!wishes_.stands || wishes_.stands(then->parts)) {
        return then;
      }
      if (!first.has_value()) {
        first = std::move(then);
      }
      if (++found == kLookAhead) {
        break;
      }
    }
    return first;
  }

  //! Anything that can come now, what touches something first.
  [[nodiscard]] std::optional<Built> anyNext(const Built& built) const {
    for (const bool touching : {true, false}) {
      for (std::size_t u = 0; u < units_.size(); ++u) {
        Built then = built;
        if ((!touching || anyOf(units_[u].touches, built.has)) &&
            tryPutWithPins(then, static_cast<int>(u))) {
          return then;
        }
      }
    }
    return std::nullopt;
  }

  //! Pins that hold only what is there have nothing to wait for.
  void putFinishedPins(Built& built) const {
    for (std::size_t u = 0; u < units_.size(); ++u) {
      if (built.has[u] == 0 && units_[u].fastener && allOf(units_[u].touches, built.has)) {
        tryPut(built, static_cast<int>(u));
      }
    }
  }

  //! All units, or fewer if that beginning leads to no end.
  [[nodiscard]] std::vector<int> orderFrom(int first) const {
    Built built = nothing();
    if (!tryPutWithPins(built, first)) {
      return {};
    }
    putFinishedPins(built);
    while (built.order.size() < units_.size()) {
      std::optional<Built> then = next(built);
      if (!then.has_value()) {
        then = anyNext(built);
      }
      if (!then.has_value()) {
        break;
      }
      built = std::move(*then);
      putFinishedPins(built);
    }
    return built.order;
  }

  [[nodiscard]] Faults faultsOf(const std::vector<int>& order) const {
    Faults faults;
    double floor = 1e9;
    double lastFloor = 0.0;
    int pieces = 1;
    std::vector<char> has(units_.size(), 0);
    std::vector<int> parts;
    for (std::size_t i = 0; i < order.size(); ++i) {
      const AssemblyUnit& unit = units_[at(order[i])];
      has[at(order[i])] = 1;
      parts.insert(parts.end(), unit.removal.parts.begin(), unit.removal.parts.end());
      if (!unit.fastener) {
        const bool first = faults.start < 0.0;
        faults.start = first ? std::max(0.0, unit.floor - floor_) : faults.start;
        faults.downwards += (first ? faults.start > kLower : unit.floor < floor - kLower) ? 1 : 0;
        floor = std::min(floor, unit.floor);
        lastFloor = unit.floor;
      }
      // Pins go in together with what they hold.
      if (i + 1 == order.size() || !units_[at(order[i + 1])].fastener) {
        faults.falling += wishes_.rests && !wishes_.rests(parts) ? 1 : 0;
        const int now = countPieces(units_, has);
        faults.loose += std::max(0, now - pieces);
        faults.hanging += now > pieces && lastFloor > floor_ + kLower ? 1 : 0;
        pieces = now;
      }
    }
    return faults;
  }

  //! Removals with the best ways out in the new order.
  [[nodiscard]] std::optional<std::vector<Removal>> removalsOf(
      const std::vector<int>& order) const {
    std::vector<int> all;
    for (const AssemblyUnit& unit : units_) {
      all.insert(all.end(), unit.removal.parts.begin(), unit.removal.parts.end());
    }
    std::sort(all.begin(), all.end());
    DisassemblyState state(graphs_.blocking, graphs_.neighbours, std::move(all));
    std::vector<Removal> removals;
    for (auto u = order.rbegin(); u != order.rend(); ++u) {
      Removal removal = units_[at(*u)].removal;
      removal.legs.clear();
      if (removals.size() + 1 < units_.size()) {
        const std::optional<int> way = findWayOut(graphs_, state, removal.parts);
        if (!way.has_value()) {
          return std::nullopt;
        }
        removal.legs.push_back(clearingLeg(graphs_, state, removal.parts, *way));
      }
      state.remove(removal.parts);
      removals.push_back(std::move(removal));
    }
    return removals;
  }

  const DisassemblyGraphs& graphs_;
  const DisassemblyWishes& wishes_;
  std::vector<AssemblyUnit> units_;  // in the old order of building
  double floor_ = 1e9;
};

}  // namespace

void buildUpwards(const DisassemblyGraphs& graphs,
                  const DisassemblyWishes& wishes,
                  DisassemblyGroup& group) {
  const bool forced = std::any_of(group.removals.begin(),
                                  group.removals.end(),
                                  [](const Removal& removal) { return removal.forced; });
  if (forced || group.removals.size() < 3 || group.removals.size() > kMaxUnits) {
    return;
  }
  if (std::optional<std::vector<Removal>> order = Ordering(graphs, wishes, group.removals).better();
      order.has_value()) {
    group.removals = std::move(*order);
  }
}

}  // namespace liftarm::analysis
