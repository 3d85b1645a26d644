#include "analysis/disassembly_state.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "base/index.h"

namespace liftarm::analysis {

namespace {

using base::at;

//! One part on the stack of a depth-first search that does not call itself.
struct Visit {
  int part = -1;
  int from = -1;
  std::size_t next = 0;
};

//! Tarjan's search for strongly connected sets, without recursion: models may be long chains.
class StrongSets {
 public:
  StrongSets(const BlockingGraph& graph, int direction, const std::vector<char>& active)
      : graph_(graph),
        direction_(direction),
        active_(active),
        order_(active.size(), -1),
        low_(active.size(), 0),
        onStack_(active.size(), 0) {}

  //! The sets, sinks first.
  std::vector<std::vector<int>> find(const std::vector<int>& parts) {
    for (const int part : parts) {
      if (order_[at(part)] < 0) {
        search(part);
      }
    }
    return std::move(sets_);
  }

 private:
  void enter(int part, int from) {
    order_[at(part)] = low_[at(part)] = count_++;
    onStack_[at(part)] = 1;
    stack_.push_back(part);
    visits_.push_back({part, from, 0});
  }

  void search(int root) {
    enter(root, -1);
    while (!visits_.empty()) {
      Visit& visit = visits_.back();
      const std::vector<int>& next = graph_.blockers(direction_, visit.part);
      if (visit.next < next.size()) {
        const int other = next[visit.next++];
        if (active_[at(other)] == 0) {
          continue;
        }
        if (order_[at(other)] < 0) {
          enter(other, visit.part);
        } else if (onStack_[at(other)] != 0) {
          low_[at(visit.part)] = std::min(low_[at(visit.part)], order_[at(other)]);
        }
        continue;
      }
      leave();
    }
  }

  void leave() {
    const Visit visit = visits_.back();
    visits_.pop_back();
    if (low_[at(visit.part)] == order_[at(visit.part)]) {
      std::vector<int> set;
      int part = -1;
      do {
        part = stack_.back();
        stack_.pop_back();
        onStack_[at(part)] = 0;
        set.push_back(part);
      } while (part != visit.part);
      std::sort(set.begin(), set.end());
      sets_.push_back(std::move(set));
    }
    if (visit.from >= 0) {
      low_[at(visit.from)] = std::min(low_[at(visit.from)], low_[at(visit.part)]);
    }
  }

  const BlockingGraph& graph_;
  int direction_;
  const std::vector<char>& active_;
  std::vector<int> order_;
  std::vector<int> low_;
  std::vector<char> onStack_;
  std::vector<int> stack_;
  std::vector<Visit> visits_;
  std::vector<std::vector<int>> sets_;
  int count_ = 0;
};

}  // namespace

std::vector<std::vector<int>> findNeighbours(const Scene& scene) {
  std::vector<std::vector<int>> neighbours(scene.parts.size());
  for (const model::Connection& c : scene.connections) {
    if (isGood(c.fit)) {
      neighbours[at(c.male)].push_back(c.female);
      neighbours[at(c.female)].push_back(c.male);
    }
  }
  for (std::vector<int>& list : neighbours) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return neighbours;
}

DisassemblyState::DisassemblyState(const BlockingGraph& graph,
                                   const std::vector<std::vector<int>>& neighbours,
                                   std::vector<int> parts)
    : graph_(graph),
      neighbours_(neighbours),
      parts_(std::move(parts)),
      active_(neighbours.size(), 0) {
  for (const int part : parts_) {
    active_[at(part)] = 1;
  }
  for (std::size_t d = 0; d < graph.directions().size(); ++d) {
    counts_.emplace_back(neighbours.size(), 0);
    for (const int part : parts_) {
      for (const int blocker : graph.blockers(static_cast<int>(d), part)) {
        counts_[d][at(part)] += active_[at(blocker)];
      }
    }
  }
}

bool DisassemblyState::isFree(int direction, const std::vector<int>& set) const {
  return std::all_of(set.begin(), set.end(), [&](int part) {
    if (blockerCount(direction, part) == 0) {
      return true;
    }
    const std::vector<int>& blockers = graph_.blockers(direction, part);
    return std::all_of(blockers.begin(), blockers.end(), [&](int blocker) {
      return !has(blocker) || std::binary_search(set.begin(), set.end(), blocker);
    });
  });
}

void DisassemblyState::remove(const std::vector<int>& set) {
  for (const int part : set) {
    active_[at(part)] = 0;
    for (std::size_t d = 0; d < counts_.size(); ++d) {
      // Those that this part blocks along d are those that block it the other way.
      for (const int other : graph_.blockers(static_cast<int>(d ^ 1U), part)) {
        --counts_[d][at(other)];
      }
    }
  }
  parts_.erase(std::remove_if(parts_.begin(), parts_.end(), [&](int part) { return !has(part); }),
               parts_.end());
}

std::vector<std::vector<int>> DisassemblyState::componentsOf(
    const std::vector<char>& inside) const {
  std::vector<char> open = inside;
  std::vector<std::vector<int>> components;
  for (const int root : parts_) {
    if (open[at(root)] == 0) {
      continue;
    }
    std::vector<int> found{root};
    open[at(root)] = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      for (const int next : neighbours_[at(found[i])]) {
        if (open[at(next)] != 0) {
          open[at(next)] = 0;
          found.push_back(next);
        }
      }
    }
    std::sort(found.begin(), found.end());
    components.push_back(std::move(found));
  }
  return components;
}

std::vector<std::vector<int>> DisassemblyState::components() const {
  return componentsOf(active_);
}

std::vector<std::vector<int>> DisassemblyState::componentsWithout(
    const std::vector<int>& set) const {
  std::vector<char> inside = active_;
  for (const int part : set) {
    inside[at(part)] = 0;
  }
  return componentsOf(inside);
}

std::vector<int> DisassemblyState::withLoose(const std::vector<int>& set) const {
  std::vector<std::vector<int>> left = componentsWithout(set);
  if (left.size() < 2) {
    return set;
  }
  const auto smaller = [](const auto& a, const auto& b) { return a.size() < b.size(); };
  left.erase(std::max_element(left.begin(), left.end(), smaller));
  std::vector<int> larger = set;
  for (const std::vector<int>& loose : left) {
    larger.insert(larger.end(), loose.begin(), loose.end());
  }
  std::sort(larger.begin(), larger.end());
  return 2 * larger.size() <= parts_.size() && connected(larger) ? larger : set;
}

bool DisassemblyState::connected(const std::vector<int>& set) const {
  std::vector<char> inside(active_.size(), 0);
  for (const int part : set) {
    inside[at(part)] = 1;
  }
  return componentsOf(inside).size() <= 1;
}

std::vector<char> DisassemblyState::cutParts() const {
  std::vector<char> cut(active_.size(), 0);
  std::vector<int> order(active_.size(), -1);
  std::vector<int> low(active_.size(), 0);
  int count = 0;
  for (const int root : parts_) {
    if (order[at(root)] >= 0) {
      continue;
    }
    int branches = 0;
    std::vector<Visit> visits{{root, -1, 0}};
    order[at(root)] = low[at(root)] = count++;
    while (!visits.empty()) {
      Visit& visit = visits.back();
      const std::vector<int>& next = neighbours_[at(visit.part)];
      if (visit.next < next.size()) {
        const int other = next[visit.next++];
        if (!has(other) || other == visit.from) {
          continue;
        }
        if (order[at(other)] >= 0) {
          low[at(visit.part)] = std::min(low[at(visit.part)], order[at(other)]);
        } else {
          order[at(other)] = low[at(other)] = count++;
          branches += visit.part == root ? 1 : 0;
          visits.push_back({other, visit.part, 0});
        }
        continue;
      }
      const Visit done = visit;
      visits.pop_back();
      if (done.from >= 0) {
        low[at(done.from)] = std::min(low[at(done.from)], low[at(done.part)]);
        if (done.from != root && low[at(done.part)] >= order[at(done.from)]) {
          cut[at(done.from)] = 1;
        }
      }
    }
    cut[at(root)] = branches > 1 ? 1 : 0;
  }
  return cut;
}

std::vector<std::vector<int>> DisassemblyState::lockedSets(int direction) const {
  StrongSets search(graph_, direction, active_);
  std::vector<std::vector<int>> locked;
  for (std::vector<int>& set : search.find(parts_)) {
    if (set.size() > 1 && set.size() < parts_.size() && isFree(direction, set)) {
      locked.push_back(std::move(set));
    }
  }
  return locked;
}

std::vector<int> DisassemblyState::closure(int direction, int part) const {
  std::vector<char> inside(active_.size(), 0);
  std::vector<int> found{part};
  inside[at(part)] = 1;
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (const int blocker : graph_.blockers(direction, found[i])) {
      if (has(blocker) && inside[at(blocker)] == 0) {
        inside[at(blocker)] = 1;
        found.push_back(blocker);
      }
    }
  }
  // All of a dense model may be found: to go through it once is quicker than to sort.
  found.clear();
  std::copy_if(parts_.begin(), parts_.end(), std::back_inserter(found), [&](int other) {
    return inside[at(other)] != 0;
  });
  return found;
}

std::vector<std::vector<int>> DisassemblyState::closures(int direction) const {
  StrongSets search(graph_, direction, active_);
  std::vector<int> strongSet(active_.size(), -1);
  int count = 0;
  for (const std::vector<int>& set : search.find(parts_)) {
    for (const int part : set) {
      strongSet[at(part)] = count;
    }
    ++count;
  }
  std::vector<char> known(at(count), 0);
  std::vector<std::vector<int>> result;
  for (const int part : parts_) {
    char& isKnown = known[at(strongSet[at(part)])];
    if (isKnown == 0) {
      isKnown = 1;
      result.push_back(closure(direction, part));
    }
  }
  return result;
}

std::vector<std::vector<int>> DisassemblyState::setsThatDivideNothing() const {
  std::vector<std::vector<int>> sets;
  for (std::size_t d = 0; d < graph_.directions().size(); ++d) {
    for (std::vector<int>& set : closures(static_cast<int>(d))) {
      if (set.size() < parts_.size() && connected(set) && connected(others(set))) {
        sets.push_back(std::move(set));
      }
    }
  }
  std::stable_sort(
      sets.begin(), sets.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
  return sets;
}

std::vector<int> DisassemblyState::others(const std::vector<int>& set) const {
  std::vector<int> result;
  std::set_difference(
      parts_.begin(), parts_.end(), set.begin(), set.end(), std::back_inserter(result));
  return result;
}

}  // namespace liftarm::analysis
