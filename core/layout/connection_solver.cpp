#include "layout/connection_solver.h"

#include <algorithm>

#include "base/hash.h"

namespace liftarm::layout {

namespace {

using lattice::Axis;
using lattice::Cell;
using mechanisms::MechanismCell;
using mechanisms::MechanismTable;
using mechanisms::OrientedMechanism;
using mechanisms::TableEntry;

constexpr double kDanglingCost = 0.3;    // a head that holds nothing, in parts
constexpr double kExtraHoleBonus = 0.2;  // a second head in one beam makes the corner stiffer
constexpr std::size_t kMaxCandidates = 160;
constexpr int kMaxNodes = 400;
constexpr std::size_t kKnownLimit = 400000;

//! A mechanism that fits at a place, and what it joins.
struct Candidate {
  PlacedMechanism placed;
  std::uint32_t terminals = 0;
  double cost = 0.0;
  double value = 0.0;  //!< cost for each join
};

int countBits(std::uint32_t bits) {
  int count = 0;
  for (; bits != 0; bits &= bits - 1) {
    ++count;
  }
  return count;
}

bool nearCentre(Cell c, int radius) {
  return c.x * c.x + c.y * c.y + c.z * c.z <= kReachSquared && c.x >= -radius && c.x <= radius &&
         c.y >= -radius && c.y <= radius && c.z >= -radius && c.z <= radius;
}

class Search {
 public:
  Search(const LocalProblem& problem, const MechanismTable& table)
      : problem_(problem), table_(table) {}

  Connection run(int radius) {
    collect(radius);
    std::array<std::int8_t, LocalProblem::kMaxTerminals> cluster = problem_.cluster;
    best_.failed = clustersOf(cluster) - 1;
    best_.cost = 0.0;
    if (best_.failed > 0 && !candidates_.empty()) {
      descend(cluster, best_.failed, 0.0);
    }
    return best_;
  }

 private:
  [[nodiscard]] int clustersOf(
      const std::array<std::int8_t, LocalProblem::kMaxTerminals>& cluster) const {
    std::uint32_t seen = 0;
    for (int t = 0; t < problem_.terminals; ++t) {
      seen |= 1U << static_cast<unsigned>(cluster[static_cast<std::size_t>(t)]);
    }
    return countBits(seen);
  }

  //! Only a single pin through the joint's own axis may join beams that must turn against each
  //! other.
  [[nodiscard]] bool respectsJoint(const OrientedMechanism& m,
                                   Cell at,
                                   std::uint32_t joined) const {
    if (!problem_.isJoint) {
      return true;
    }
    int group = -1;
    bool mixed = false;
    for (int t = 0; t < problem_.terminals; ++t) {
      const int g = problem_.group[static_cast<std::size_t>(t)];
      if ((joined >> static_cast<unsigned>(t) & 1U) != 0U && g >= 0) {
        mixed = mixed || (group >= 0 && group != g);
        group = g;
      }
    }
    if (!mixed) {
      return true;
    }
    const int k = lattice::index(problem_.jointAxis);
    return m.shape.parts.size() == 1 &&
           std::all_of(m.shape.cells.begin(), m.shape.cells.end(), [&](const MechanismCell& c) {
             const Cell p = c.at + at;
             return c.head && c.axis == problem_.jointAxis && p[(k + 1) % 3] == 0 &&
                    p[(k + 2) % 3] == 0;
           });
  }

  void tryPlace(std::int32_t id, Cell at) {
    const OrientedMechanism& m = table_.oriented(id);
    Candidate candidate{{id, at}, 0, m.cost};
    bool strangers = false;
    for (const MechanismCell& cell : m.shape.cells) {
      const Cell p = cell.at + at;
      if (!inBox(p)) {
        return;
      }
      const int box = boxIndex(p);
      if (problem_.blocked(box)) {
        return;
      }
      const LocalHole* hole = problem_.holeAt(box);
      if (!cell.head) {
        if (hole != nullptr) {
          return;
        }
        continue;
      }
      if (hole == nullptr) {
        if (cell.mustHold) {
          return;
        }
        candidate.cost += kDanglingCost;
        continue;
      }
      if (hole->used || hole->axis != cell.axis) {
        return;
      }
      if (hole->terminal < 0) {
        strangers = true;  // a beam of a neighbouring junction is held too
        continue;
      }
      const std::uint32_t bit = 1U << static_cast<unsigned>(hole->terminal);
      candidate.cost -= (candidate.terminals & bit) != 0U ? kExtraHoleBonus : 0.0;
      candidate.terminals |= bit;
    }
    if (respectsJoint(m, at, candidate.terminals) && (!problem_.isJoint || !strangers)) {
      candidates_.push_back(candidate);
    }
  }

  //! Holes of the terminals that a mechanism may use, by terminal.
  [[nodiscard]] std::vector<const LocalHole*> usableHoles(int radius) const {
    std::vector<const LocalHole*> usable;
    for (const LocalHole& hole : problem_.holes()) {
      if (hole.terminal >= 0 && !hole.used && nearCentre(hole.at, radius)) {
        usable.push_back(&hole);
      }
    }
    return usable;
  }

  void collect(int radius) {
    const std::vector<const LocalHole*> usable = usableHoles(radius);
    for (const LocalHole* a : usable) {
      const std::int8_t cluster = problem_.cluster[static_cast<std::size_t>(a->terminal)];
      for (const LocalHole* b : usable) {
        if (b->terminal <= a->terminal ||
            problem_.cluster[static_cast<std::size_t>(b->terminal)] == cluster) {
          continue;
        }
        for (const TableEntry& entry : table_.between(b->at - a->at, a->axis, b->axis)) {
          const OrientedMechanism& m = table_.oriented(entry.mechanism);
          const Cell head = m.shape.cells[static_cast<std::size_t>(entry.headA)].at;
          tryPlace(entry.mechanism, a->at - head);
        }
      }
    }
    const auto before = [](const Candidate& a, const Candidate& b) {
      if (a.value != b.value) {
        return a.value < b.value;
      }
      return a.placed.oriented != b.placed.oriented ? a.placed.oriented < b.placed.oriented
                                                    : a.placed.at < b.placed.at;
    };
    for (Candidate& candidate : candidates_) {
      candidate.value = candidate.cost / static_cast<double>(countBits(candidate.terminals) - 1);
    }
    std::sort(candidates_.begin(), candidates_.end(), before);
    candidates_.erase(std::unique(candidates_.begin(),
                                  candidates_.end(),
                                  [](const Candidate& a, const Candidate& b) {
                                    return a.placed.oriented == b.placed.oriented &&
                                           a.placed.at == b.placed.at;
                                  }),
                      candidates_.end());
    if (candidates_.size() > kMaxCandidates) {
      candidates_.resize(kMaxCandidates);
    }
  }

  [[nodiscard]] bool fits(const PlacedMechanism& placed) const {
    const std::vector<MechanismCell>& cells = table_.oriented(placed.oriented).shape.cells;
    return std::all_of(cells.begin(), cells.end(), [&](const MechanismCell& cell) {
      return taken_[static_cast<std::size_t>(boxIndex(cell.at + placed.at))] == 0;
    });
  }

  void take(const PlacedMechanism& placed, std::uint8_t mark) {
    for (const MechanismCell& cell : table_.oriented(placed.oriented).shape.cells) {
      taken_[static_cast<std::size_t>(boxIndex(cell.at + placed.at))] = mark;
    }
  }

  void descend(const std::array<std::int8_t, LocalProblem::kMaxTerminals>& cluster,
               int left,
               double cost) {
    if (left < best_.failed || (left == best_.failed && cost < best_.cost)) {
      best_.mechanisms = chosen_;
      best_.failed = left;
      best_.cost = cost;
    }
    if (left == 0 || ++nodes_ > kMaxNodes) {
      return;
    }
    for (const Candidate& candidate : candidates_) {
      std::uint32_t joined = 0;
      for (int t = 0; t < problem_.terminals; ++t) {
        if ((candidate.terminals >> static_cast<unsigned>(t) & 1U) != 0U) {
          joined |= 1U << static_cast<unsigned>(cluster[static_cast<std::size_t>(t)]);
        }
      }
      const int gain = countBits(joined) - 1;
      // Always grow the cluster of the first beam: every set of mechanisms is tried in one order
      // only.
      const bool growsFirst = (joined >> static_cast<unsigned>(cluster[0]) & 1U) != 0U;
      if (gain <= 0 || !growsFirst || (best_.failed == 0 && cost + candidate.cost >= best_.cost)) {
        continue;
      }
      if (!fits(candidate.placed)) {
        continue;
      }
      std::array<std::int8_t, LocalProblem::kMaxTerminals> merged = cluster;
      for (int t = 0; t < problem_.terminals; ++t) {
        const auto mine = static_cast<unsigned>(cluster[static_cast<std::size_t>(t)]);
        if ((joined >> mine & 1U) != 0U) {
          merged[static_cast<std::size_t>(t)] = cluster[0];
        }
      }
      chosen_.push_back(candidate.placed);
      take(candidate.placed, 1);
      descend(merged, left - gain, cost + candidate.cost);
      take(candidate.placed, 0);
      chosen_.pop_back();
      if (nodes_ > kMaxNodes) {
        return;
      }
    }
  }

  const LocalProblem& problem_;
  const MechanismTable& table_;
  std::vector<Candidate> candidates_;
  std::vector<PlacedMechanism> chosen_;
  std::array<std::uint8_t, kBoxCells> taken_{};  // cells of the chosen mechanisms
  Connection best_;
  int nodes_ = 0;
};

}  // namespace

void LocalProblem::clear() {
  for (const int cell : touched_) {
    content_[static_cast<std::size_t>(cell)] = 0;
  }
  touched_.clear();
  holes_.clear();
  terminals = 0;
  isJoint = false;
  group.fill(-1);
  for (std::size_t t = 0; t < cluster.size(); ++t) {
    cluster[t] = static_cast<std::int8_t>(t);
  }
}

void LocalProblem::touch(int cell) {
  if (content_[static_cast<std::size_t>(cell)] == 0) {
    touched_.push_back(cell);
  }
}

void LocalProblem::block(int cell) {
  touch(cell);
  content_[static_cast<std::size_t>(cell)] = -1;
}

void LocalProblem::addHole(const LocalHole& hole) {
  const int cell = boxIndex(hole.at);
  touch(cell);
  std::int16_t& content = content_[static_cast<std::size_t>(cell)];
  if (content > 0) {
    content = -1;
    return;
  }
  holes_.push_back(hole);
  content = static_cast<std::int16_t>(holes_.size());
}

void LocalProblem::useHole(int cell) {
  const std::int16_t content = content_[static_cast<std::size_t>(cell)];
  if (content > 0) {
    holes_[static_cast<std::size_t>(content - 1)].used = true;
  } else {
    block(cell);
  }
}

void LocalProblem::join(int terminalA, int terminalB) {
  const std::int8_t from = cluster[static_cast<std::size_t>(terminalB)];
  const std::int8_t to = cluster[static_cast<std::size_t>(terminalA)];
  std::replace(cluster.begin(), cluster.end(), from, to);
}

const LocalHole* LocalProblem::holeAt(int cell) const {
  const std::int16_t content = content_[static_cast<std::size_t>(cell)];
  return content > 0 ? &holes_[static_cast<std::size_t>(content - 1)] : nullptr;
}

bool LocalProblem::blocked(int cell) const {
  return content_[static_cast<std::size_t>(cell)] < 0;
}

std::uint64_t LocalProblem::hash() const {
  std::uint64_t sum = 0;  // each cell was touched once, so a sum does not depend on the order
  for (const int cell : touched_) {
    const std::int16_t content = content_[static_cast<std::size_t>(cell)];
    std::uint64_t code = 0;
    if (content > 0) {
      const LocalHole& hole = holes_[static_cast<std::size_t>(content - 1)];
      code = 2U + static_cast<std::uint64_t>(hole.terminal + 1) * 8U +
             static_cast<std::uint64_t>(lattice::index(hole.axis)) * 2U + (hole.used ? 1U : 0U);
    }
    sum += base::mixHash(static_cast<std::uint64_t>(cell), code);
  }
  std::uint64_t hash = base::mixHash(sum, static_cast<std::uint64_t>(terminals));
  for (int t = 0; t < terminals; ++t) {
    const auto at = static_cast<std::size_t>(t);
    hash = base::mixHash(hash, static_cast<std::uint64_t>(cluster[at] * 64 + group[at] + 1));
  }
  return base::mixHash(hash,
                       isJoint ? 1U + static_cast<std::uint64_t>(lattice::index(jointAxis)) : 0U);
}

const Connection& ConnectionSolver::solve(const LocalProblem& problem) {
  const std::uint64_t key = problem.hash();
  const auto found = known_.find(key);
  if (found != known_.end()) {
    ++hits_;
    return found->second;
  }
  ++misses_;
  if (known_.size() > kKnownLimit) {
    known_.clear();
  }
  Connection answer = Search(problem, *table_).run(2);
  if (answer.failed > 0) {
    answer = Search(problem, *table_).run(3);
  }
  return known_.emplace(key, std::move(answer)).first->second;
}

}  // namespace liftarm::layout
