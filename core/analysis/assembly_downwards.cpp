#include "analysis/assembly_downwards.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

#include "base/index.h"

namespace liftarm::analysis {

namespace {

using base::at;

// Of what can go next, when none of it leaves the rest in one piece.
constexpr std::size_t kMostTried = 200;

//! Whether a unit can leave what is there along some direction.
bool canGo(const AssemblyUnit& unit, const std::vector<char>& has) {
  const auto& hits = unit.hits;
  return std::any_of(hits.begin(), hits.end(), [&](const std::vector<int>& blockers) {
    return std::none_of(
        blockers.begin(), blockers.end(), [&](int other) { return has[at(other)] != 0; });
  });
}

}  // namespace

int countPieces(const std::vector<AssemblyUnit>& units, std::vector<char> there) {
  int pieces = 0;
  std::vector<int> open;
  for (std::size_t u = 0; u < units.size(); ++u) {
    if (there[u] == 0) {
      continue;
    }
    ++pieces;
    there[u] = 0;
    open.push_back(static_cast<int>(u));
    while (!open.empty()) {
      const std::vector<int>& near = units[at(open.back())].touches;
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

std::vector<int> orderDownwards(const std::vector<AssemblyUnit>& units) {
  using Key = std::tuple<double, bool, int>;
  std::vector<Key> keys;
  for (std::size_t u = 0; u < units.size(); ++u) {
    keys.emplace_back(
        -std::floor(2.0 * units[u].middle.z + 0.5), !units[u].fastener, static_cast<int>(u));
  }
  std::sort(keys.begin(), keys.end());
  std::vector<char> has(units.size(), 1);
  int pieces = countPieces(units, has);
  std::vector<int> order;
  while (order.size() < units.size()) {
    int chosen = -1;
    std::size_t tried = 0;
    for (const Key& key : keys) {
      const int u = std::get<2>(key);
      if (has[at(u)] == 0 || !canGo(units[at(u)], has)) {
        continue;
      }
      chosen = chosen < 0 ? u : chosen;
      has[at(u)] = 0;
      const bool loose = countPieces(units, has) > pieces;
      has[at(u)] = 1;
      if (!loose || ++tried == kMostTried) {
        chosen = loose ? chosen : u;
        break;
      }
    }
    if (chosen < 0) {
      return {};
    }
    has[at(chosen)] = 0;
    pieces = countPieces(units, has);
    order.push_back(chosen);
  }
  std::reverse(order.begin(), order.end());
  return order;
}

}  // namespace liftarm::analysis
