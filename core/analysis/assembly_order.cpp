#include "analysis/assembly_order.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>

#include "analysis/assembly_units.h"
#include "analysis/disassembly_state.h"

namespace liftarm::analysis {

namespace {

using lattice::Vec3;

// More are left in the order in which they are: the work grows with their square.
constexpr std::size_t kMaxUnits = 600;

constexpr std::size_t kBeginnings = 12;
constexpr std::size_t kManyUnits = 200;

// Of the next few things, one with which it stands is taken.
constexpr std::size_t kLookAhead = 4;

// Lower than what is there by so much, modules, it is built downwards.
constexpr double kLower = 0.6;

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

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
    for (const int first : beginnings()) {
      std::vector<int> order = orderFrom(first);
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
  //! Single parts that stand lowest and need nothing before them but pins.
  [[nodiscard]] std::vector<int> beginnings() const {
    std::vector<int> found;
    for (std::size_t u = 0; u < units_.size(); ++u) {
      const AssemblyUnit& unit = units_[u];
      if (!unit.fastener && unit.removal.parts.size() == 1 && !unit.keepsPlace &&
          std::all_of(unit.before.begin(), unit.before.end(), [&](int needed) {
            return isPinOf(needed, unit) && units_[at(needed)].before.empty();
          })) {
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

  [[nodiscard]] bool isPinOf(int pin, const AssemblyUnit& unit) const {
    return units_[at(pin)].fastener &&
           std::binary_search(unit.touches.begin(), unit.touches.end(), pin);
  }

  //! A unit with the pins that come before it, and those that it is fixed with then.
  struct Next {
    int unit = -1;
    std::vector<int> pins;
    std::vector<int> pinsAfter;
  };

  struct Built {
    std::vector<int> order;
    std::vector<char> has;  //!< by unit
    std::vector<int> parts;
  };

  void put(Built& built, int u) const {
    built.order.push_back(u);
    built.has[at(u)] = 1;
    const std::vector<int>& parts = units_[at(u)].removal.parts;
    built.parts.insert(built.parts.end(), parts.begin(), parts.end());
  }

  void put(Built& built, const Next& next) const {
    for (const int pin : next.pins) {
      put(built, pin);
    }
    put(built, next.unit);
    for (const int pin : next.pinsAfter) {
      put(built, pin);
    }
  }

  static bool anyOf(const std::vector<int>& units, const std::vector<char>& in) {
    return std::any_of(units.begin(), units.end(), [&](int u) { return in[at(u)] != 0; });
  }

  static bool allOf(const std::vector<int>& units, const std::vector<char>& in) {
    return std::all_of(units.begin(), units.end(), [&](int u) { return in[at(u)] != 0; });
  }

  //! Pins that can go in once `there` is there, and fix a unit to what is built.
  [[nodiscard]] std::vector<int> pinsThatHold(const Built& built,
                                              const std::vector<char>& there,
                                              const AssemblyUnit& unit) const {
    std::vector<int> pins;
    for (const int pin : unit.touches) {
      if (there[at(pin)] == 0 && units_[at(pin)].fastener && allOf(units_[at(pin)].before, there) &&
          anyOf(units_[at(pin)].touches, built.has)) {
        pins.push_back(pin);
      }
    }
    return pins;
  }

  //! \return What could come next with this unit, or nothing if it must wait or would touch
  //! nothing.
  [[nodiscard]] std::optional<Next> reach(const Built& built, int u) const {
    const AssemblyUnit& unit = units_[at(u)];
    Next next{u, {}, {}};
    std::vector<char> there = built.has;
    const auto take = [&](int pin) {
      next.pins.push_back(pin);
      there[at(pin)] = 1;
    };
    for (const int needed : unit.before) {
      if (there[at(needed)] != 0) {
        continue;
      }
      if (!allOf(units_[at(needed)].before, there) ||
          !(isPinOf(needed, unit) ||
            (units_[at(needed)].fastener && anyOf(units_[at(needed)].touches, built.has)))) {
        return std::nullopt;
      }
      take(needed);
    }
    const std::vector<int> holding = pinsThatHold(built, there, unit);
    std::for_each(holding.begin(), holding.end(), take);
    const bool touching = std::any_of(unit.touches.begin(), unit.touches.end(), [&](int other) {
      return built.has[at(other)] != 0 ||
             (there[at(other)] != 0 && anyOf(units_[at(other)].touches, built.has));
    });
    there[at(u)] = 1;
    next.pinsAfter = pinsThatHold(built, there, unit);
    return touching || !next.pinsAfter.empty() ? std::optional(next) : std::nullopt;
  }

  [[nodiscard]] std::optional<Next> choose(const Built& built) const {
    using Key = std::tuple<double, double, int>;
    std::vector<std::pair<Key, Next>> found;
    const Vec3 last = units_[at(built.order.back())].middle;
    for (std::size_t u = 0; u < units_.size(); ++u) {
      if (built.has[u] != 0 || units_[u].fastener) {
        continue;
      }
      if (std::optional<Next> next = reach(built, static_cast<int>(u)); next.has_value()) {
        const double level = std::floor(2.0 * units_[u].floor + 0.5);
        const double way = std::floor(64.0 * lattice::length(units_[u].middle - last) + 0.5);
        found.emplace_back(Key{level, way, static_cast<int>(u)}, std::move(*next));
      }
    }
    if (found.empty()) {
      return std::nullopt;
    }
    std::sort(
        found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t i = 0; wishes_.stands && i < std::min(found.size(), kLookAhead); ++i) {
      Built then = built;
      put(then, found[i].second);
      if (wishes_.stands(then.parts)) {
        return found[i].second;
      }
    }
    return found.front().second;
  }

  //! Anything that can come now, what touches something first; -1 if nothing can.
  [[nodiscard]] int anyNext(const Built& built) const {
    int loose = -1;
    for (std::size_t u = 0; u < units_.size(); ++u) {
      if (built.has[u] == 0 && allOf(units_[u].before, built.has)) {
        if (anyOf(units_[u].touches, built.has)) {
          return static_cast<int>(u);
        }
        loose = loose < 0 ? static_cast<int>(u) : loose;
      }
    }
    return loose;
  }

  //! Pins that hold only what is there have nothing to wait for.
  void putFinishedPins(Built& built) const {
    for (std::size_t u = 0; u < units_.size(); ++u) {
      const AssemblyUnit& unit = units_[u];
      if (built.has[u] == 0 && unit.fastener && allOf(unit.before, built.has) &&
          allOf(unit.touches, built.has)) {
        put(built, static_cast<int>(u));
      }
    }
  }

  //! All units, or fewer if what must come before what does not allow to begin there.
  [[nodiscard]] std::vector<int> orderFrom(int first) const {
    Built built{{}, std::vector<char>(units_.size(), 0), {}};
    for (const int pin : units_[at(first)].before) {
      put(built, pin);
    }
    put(built, first);
    putFinishedPins(built);
    while (built.order.size() < units_.size()) {
      if (const std::optional<Next> next = choose(built); next.has_value()) {
        put(built, *next);
      } else if (const int any = anyNext(built); any >= 0) {
        put(built, any);
      } else {
        break;
      }
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
        const int now = countPieces(has);
        faults.loose += std::max(0, now - pieces);
        faults.hanging += now > pieces && lastFloor > floor_ + kLower ? 1 : 0;
        pieces = now;
      }
    }
    return faults;
  }

  //! In how many pieces the units are that are there.
  [[nodiscard]] int countPieces(std::vector<char> there) const {
    int pieces = 0;
    std::vector<int> open;
    for (std::size_t u = 0; u < units_.size(); ++u) {
      if (there[u] == 0) {
        continue;
      }
      ++pieces;
      there[u] = 0;
      open.push_back(static_cast<int>(u));
      while (!open.empty()) {
        const std::vector<int>& near = units_[at(open.back())].touches;
        open.pop_back();
        for (const int next : near) {
          if (there[at(next)] != 0) {
            there[at(next)] = 0;
            open.push_back(next);
          }
        }
      }
    }
    return pieces;
  }

  //! Ways out of the new order; nothing if one of them is closed.
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
      const AssemblyUnit& unit = units_[at(*u)];
      Removal removal = unit.removal;
      if (!unit.keepsPlace) {
        if (!state.isFree(unit.direction, removal.parts)) {
          return std::nullopt;
        }
        removal.legs.clear();
        if (removals.size() + 1 < units_.size()) {
          removal.legs.push_back(clearingLeg(graphs_, state, removal.parts, unit.direction));
        }
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
  if (group.removals.size() < 3 || group.removals.size() > kMaxUnits) {
    return;
  }
  if (std::optional<std::vector<Removal>> order = Ordering(graphs, wishes, group.removals).better();
      order.has_value()) {
    group.removals = std::move(*order);
  }
}

}  // namespace liftarm::analysis
