#include "layout/connection_search.h"

#include <algorithm>
#include <bit>

#include "base/index.h"

namespace liftarm::layout {

namespace {

using base::at;
using lattice::Cell;
using mechanisms::MechanismCell;
using mechanisms::OrientedMechanism;
using mechanisms::TableEntry;

constexpr double kSameCost = 1e-9;
constexpr std::size_t kMaxCandidates = 160;
constexpr int kMaxNodes = 400;
constexpr int kNearRadius = 2;
constexpr int kFarRadius = 3;

// Codes of cells: empty, blocked, a free hole of a beam that need not be joined (plus its axis), a
// free hole of a terminal (plus four times its number, plus its axis).
constexpr std::uint8_t kEmpty = 0;
constexpr std::uint8_t kBlocked = 1;
constexpr std::uint8_t kStranger = 4;
constexpr std::uint8_t kTerminal = 8;

bool nearCentre(Cell c, int radius) {
  return (radius > kFarRadius || c.x * c.x + c.y * c.y + c.z * c.z <= kReachSquared) &&
         c.x >= -radius && c.x <= radius && c.y >= -radius && c.y <= radius && c.z >= -radius &&
         c.z <= radius;
}

std::array<std::int8_t, 3> packed(Cell c) {
  return {
      static_cast<std::int8_t>(c.x), static_cast<std::int8_t>(c.y), static_cast<std::int8_t>(c.z)};
}

Cell unpacked(const std::array<std::int8_t, 3>& c) {
  return {c[0], c[1], c[2]};
}

std::uint8_t codeOf(const LocalHole& hole) {
  if (hole.used) {
    return kBlocked;
  }
  const int base = hole.terminal < 0 ? int{kStranger} : kTerminal + 4 * hole.terminal;
  return static_cast<std::uint8_t>(base + lattice::index(hole.axis));
}

}  // namespace

ConnectionSearch::ConnectionSearch(const mechanisms::MechanismTable& table, ConnectionCosts costs)
    : table_(&table), costs_(costs) {
  shapes_.reserve(table.size());
  for (std::size_t id = 0; id < table.size(); ++id) {
    const OrientedMechanism& m = table.oriented(static_cast<std::int32_t>(id));
    PackedShape shape;
    shape.first = static_cast<std::uint32_t>(cells_.size());
    shape.heads = static_cast<std::uint16_t>(m.heads);
    shape.count = static_cast<std::uint16_t>(m.shape.cells.size());
    shape.cost = m.cost;
    shape.low = shape.high = packed(m.shape.cells.front().at);
    for (const MechanismCell& cell : m.shape.cells) {
      const std::array<std::int8_t, 3> place = packed(cell.at);
      for (std::size_t i = 0; i < 3; ++i) {
        shape.low[i] = std::min(shape.low[i], place[i]);
        shape.high[i] = std::max(shape.high[i], place[i]);
      }
      cells_.push_back({static_cast<std::int16_t>(boxIndex(cell.at) - boxIndex({})),
                        static_cast<std::uint8_t>(lattice::index(cell.axis)),
                        cell.mustHold,
                        place});
    }
    shapes_.push_back(shape);
  }
}

Connection ConnectionSearch::run(const LocalProblem& problem) {
  enter(problem);
  Connection answer = within(kNearRadius);
  if (answer.failed > 0) {
    answer = within(kFarRadius);
  }
  leave();
  return answer;
}

std::vector<FurtherJoin> ConnectionSearch::joins(const LocalProblem& problem, std::size_t most) {
  enter(problem);
  collect(kBoxRadius, most);
  leave();
  std::vector<FurtherJoin> joins;
  joins.reserve(candidates_.size());
  for (const Candidate& candidate : candidates_) {
    joins.push_back({candidate.placed, candidate.cost});
  }
  return joins;
}

void ConnectionSearch::enter(const LocalProblem& problem) {
  problem_ = &problem;
  for (const int cell : problem.cells()) {
    const LocalHole* hole = problem.holeAt(cell);
    codes_[at(cell)] = hole != nullptr ? codeOf(*hole) : kBlocked;
  }
}

void ConnectionSearch::leave() {
  for (const int cell : problem_->cells()) {
    codes_[at(cell)] = kEmpty;
  }
}

Connection ConnectionSearch::within(int radius) {
  collect(radius, kMaxCandidates);
  toClusters();
  std::uint32_t clusters = 0;
  for (int t = 0; t < problem_->terminals; ++t) {
    clusters |= 1U << static_cast<unsigned>(problem_->cluster[at(t)]);
  }
  best_ = {};
  best_.failed = std::popcount(clusters) - 1;
  nodes_ = 0;
  if (best_.failed > 0 && !candidates_.empty()) {
    open_.resize(std::max(open_.size(), at(best_.failed) + 1));
    open_[0].resize(candidates_.size());
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      open_[0][i] = static_cast<std::uint16_t>(i);
    }
    leastValue_ = std::max(0.0, candidates_.front().value);
    descend(0, 1U << static_cast<unsigned>(problem_->cluster[0]), best_.failed, 0.0);
  }
  return std::move(best_);
}

//! Only a single pin through the joint's own axis may join beams that must turn against each other,
//! or an axle there between stops.
bool ConnectionSearch::respectsJoint(const OrientedMechanism& m,
                                     Cell place,
                                     std::uint32_t joined) const {
  int group = -1;
  bool mixed = false;
  for (int t = 0; t < problem_->terminals; ++t) {
    const int g = problem_->group[at(t)];
    if ((joined >> static_cast<unsigned>(t) & 1U) != 0U && g >= 0) {
      mixed = mixed || (group >= 0 && group != g);
      group = g;
    }
  }
  if (!mixed) {
    return true;
  }
  const int k = lattice::index(problem_->jointAxis);
  const bool pin = m.shape.parts.size() == 1;
  return std::all_of(m.shape.cells.begin(), m.shape.cells.end(), [&](const MechanismCell& c) {
    const Cell p = c.at + place;
    return (c.head ? c.axis == problem_->jointAxis && (pin || c.mustHold) : !pin) &&
           p[(k + 1) % 3] == 0 && p[(k + 2) % 3] == 0;
  });
}

//! Whether a mechanism's body has room to draw back from a frame by a module, where it stands on
//! one side of the hole that a head is in: between two bars it may have none.
bool ConnectionSearch::comesOut(const PackedShape& shape, Cell place) const {
  const PackedCell* cells = cells_.data() + shape.first;
  const auto frameAt = [&](Cell cell) {
    const LocalHole* hole = inBox(cell) ? problem_->holeAt(boxIndex(cell)) : nullptr;
    const bool frame = hole != nullptr && hole->terminal >= 0 &&
                       (problem_->frames >> static_cast<unsigned>(hole->terminal) & 1U) != 0U;
    return frame ? hole->terminal : -1;
  };
  const auto isOwn = [&](Cell cell) {
    return std::any_of(cells, cells + shape.count, [&](const PackedCell& own) {
      return unpacked(own.at) + place == cell;
    });
  };
  for (int head = 0; head < shape.heads; ++head) {
    const Cell hole = unpacked(cells[head].at) + place;
    Cell step;
    step[cells[head].axis] = 1;
    const bool ahead = isOwn(hole + step);
    const bool through = ahead && isOwn(hole - step);
    step[cells[head].axis] = ahead ? 1 : -1;
    const int terminal = frameAt(hole);
    if (terminal >= 0 && !through &&
        std::any_of(cells + shape.heads, cells + shape.count, [&](const PackedCell& body) {
          return frameAt(unpacked(body.at) + place + step) == terminal;
        })) {
      return false;
    }
  }
  return true;
}

//! \param head Which of the mechanism's cells takes the hole.
void ConnectionSearch::tryPlace(std::int32_t id, int head, Cell hole) {
  const PackedShape& shape = shapes_[at(id)];
  const PackedCell* cells = cells_.data() + shape.first;
  const Cell place = hole - unpacked(cells[head].at);
  if (!inBox(unpacked(shape.low) + place) || !inBox(unpacked(shape.high) + place)) {
    return;
  }
  const int origin = boxIndex(place);
  for (int i = shape.heads; i < shape.count; ++i) {
    if (codes_[at(origin + cells[i].offset)] != kEmpty) {
      return;
    }
  }
  Candidate candidate{{id, place}, origin, 0, shape.cost, 0.0};
  bool strangers = false;
  for (int i = 0; i < shape.heads; ++i) {
    const std::uint8_t code = codes_[at(origin + cells[i].offset)];
    if (code == kEmpty) {
      if (cells[i].mustHold) {
        return;
      }
      candidate.cost += costs_.dangling;
      continue;
    }
    if (code == kBlocked || (code & 3U) != cells[i].axis) {
      return;
    }
    if (code < kTerminal) {
      strangers = true;  // a beam of a neighbouring junction is held too
      continue;
    }
    const std::uint32_t bit = 1U << static_cast<unsigned>((code - kTerminal) >> 2);
    candidate.cost -= (candidate.terminals & bit) != 0U ? costs_.secondHead : 0.0;
    candidate.terminals |= bit;
  }
  if ((problem_->frames & candidate.terminals) != 0U && !comesOut(shape, place)) {
    return;
  }
  if (!problem_->isJoint ||
      (!strangers && respectsJoint(table_->oriented(id), place, candidate.terminals))) {
    candidates_.push_back(candidate);
  }
}

//! Holes of the terminals that a mechanism may use.
void ConnectionSearch::findHoles(int radius) {
  holes_.clear();
  for (const LocalHole& hole : problem_->holes()) {
    if (hole.terminal >= 0 && !hole.used && nearCentre(hole.at, radius)) {
      holes_.push_back(&hole);
    }
  }
}

void ConnectionSearch::collect(int radius, std::size_t most) {
  findHoles(radius);
  candidates_.clear();
  for (const LocalHole* a : holes_) {
    const std::int8_t cluster = problem_->cluster[at(a->terminal)];
    for (const LocalHole* b : holes_) {
      if (b->terminal <= a->terminal || problem_->cluster[at(b->terminal)] == cluster) {
        continue;
      }
      const auto& entries = table_->between(b->at - a->at, a->axis, b->axis);
      work_ += entries.size();
      for (const TableEntry& entry : entries) {
        tryPlace(entry.mechanism, entry.headA, a->at);
      }
    }
  }
  sortCandidates(most);
}

//! The cheapest for each join first, each once, and not too many.
void ConnectionSearch::sortCandidates(std::size_t most) {
  for (Candidate& candidate : candidates_) {
    candidate.value = candidate.cost / static_cast<double>(std::popcount(candidate.terminals) - 1);
  }
  std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
    if (a.value != b.value) {
      return a.value < b.value;
    }
    return a.placed.oriented != b.placed.oriented ? a.placed.oriented < b.placed.oriented
                                                  : a.placed.at < b.placed.at;
  });
  candidates_.erase(std::unique(candidates_.begin(),
                                candidates_.end(),
                                [](const Candidate& a, const Candidate& b) {
                                  return a.placed.oriented == b.placed.oriented &&
                                         a.placed.at == b.placed.at;
                                }),
                    candidates_.end());
  if (candidates_.size() > most) {
    candidates_.resize(most);
  }
}

//! What the candidates join, as clusters in place of terminals.
void ConnectionSearch::toClusters() {
  for (Candidate& candidate : candidates_) {
    std::uint32_t clusters = 0;
    for (int t = 0; t < problem_->terminals; ++t) {
      if ((candidate.terminals >> static_cast<unsigned>(t) & 1U) != 0U) {
        clusters |= 1U << static_cast<unsigned>(problem_->cluster[at(t)]);
      }
    }
    candidate.terminals = clusters;
  }
}

bool ConnectionSearch::fits(const Candidate& candidate) const {
  const PackedShape& shape = shapes_[at(candidate.placed.oriented)];
  const PackedCell* cells = cells_.data() + shape.first;
  return std::all_of(cells, cells + shape.count, [&](const PackedCell& cell) {
    return taken_[at(candidate.origin + cell.offset)] == 0;
  });
}

void ConnectionSearch::take(const Candidate& candidate, std::uint8_t mark) {
  const PackedShape& shape = shapes_[at(candidate.placed.oriented)];
  const PackedCell* cells = cells_.data() + shape.first;
  for (int i = 0; i < shape.count; ++i) {
    taken_[at(candidate.origin + cells[i].offset)] = mark;
  }
}

//! \param grown Clusters joined to that of the first beam: it is grown always, so that every set of
//! mechanisms is tried in one order only.
void ConnectionSearch::descend(std::size_t depth, std::uint32_t grown, int left, double cost) {
  if (left < best_.failed || (left == best_.failed && cost < best_.cost)) {
    best_.mechanisms = chosen_;
    best_.failed = left;
    best_.cost = cost;
  }
  if (left == 0 || ++nodes_ > kMaxNodes) {
    return;
  }
  work_ += open_[depth].size();
  for (std::size_t i = 0; i < open_[depth].size(); ++i) {
    const Candidate& candidate = candidates_[open_[depth][i]];
    const std::uint32_t fresh = candidate.terminals & ~grown;
    if ((candidate.terminals & grown) == 0U || fresh == 0U) {
      continue;
    }
    const int rest = left - std::popcount(fresh);
    // Each join that is left costs no less than those of the cheapest candidate.
    const double least = cost + candidate.cost + rest * leastValue_ - kSameCost;
    if (best_.failed == 0 && least >= best_.cost) {
      continue;
    }
    chosen_.push_back(candidate.placed);
    if (rest > 0) {
      // What does not fit beside this one, or joins nothing more, is out from here on.
      take(candidate, 1);
      std::vector<std::uint16_t>& next = open_[depth + 1];
      next.clear();
      work_ += open_[depth].size();
      for (const std::uint16_t other : open_[depth]) {
        if ((candidates_[other].terminals & ~(grown | fresh)) != 0U && fits(candidates_[other])) {
          next.push_back(other);
        }
      }
      take(candidate, 0);
    }
    descend(depth + 1, grown | fresh, rest, cost + candidate.cost);
    chosen_.pop_back();
    if (nodes_ > kMaxNodes) {
      return;
    }
  }
}

}  // namespace liftarm::layout
