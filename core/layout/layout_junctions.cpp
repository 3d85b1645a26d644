#include <algorithm>

#include "base/index.h"
#include "layout/layout.h"

namespace liftarm::layout {

namespace {

using base::at;
using lattice::Axis;
using lattice::Cell;
using mechanisms::MechanismCell;
using mechanisms::OrientedMechanism;

//! Where a beam of a cover is pinned to the one before it, and to the one after it.
struct PinnedNodes {
  InlinePins before;
  InlinePins after;

  PinnedNodes(const guide::GuideRun& run, const Cover& cover, std::size_t b) {
    if (b > 0) {
      before = inlinePins(run, cover.beams[b - 1], cover.beams[b]);
    }
    if (b + 1 < cover.beams.size()) {
      after = inlinePins(run, cover.beams[b], cover.beams[b + 1]);
    }
  }

  [[nodiscard]] bool has(int node) const { return before.has(node) || after.has(node); }
};

//! Enters a neighbouring junction's mechanism; terminals whose holes it fills are joined already.
bool enterMechanism(LocalProblem* local,
                    const OrientedMechanism& m,
                    const PlacedMechanism& placed,
                    const JunctionView& other) {
  int joined = -1;
  bool leans = false;
  for (const MechanismCell& cell : m.shape.cells) {
    const Cell own = cell.at + placed.at;
    if (!other.aligned) {
      local->blockAround(lattice::toVec3(own) + other.offset);
      continue;
    }
    const Cell p = own + other.shift;
    if (!inBox(p)) {
      continue;
    }
    if (!cell.head) {
      local->block(boxIndex(p));
      continue;
    }
    const LocalHole* hole = local->holeAt(boxIndex(p));
    const bool near = p.x * p.x + p.y * p.y + p.z * p.z <= kReachSquared;
    if (hole != nullptr && hole->terminal >= 0 && near && hole->axis == cell.axis &&
        !local->isJoint) {
      if (joined >= 0 && joined != hole->terminal) {
        local->join(joined, hole->terminal);
        leans = true;
      }
      joined = hole->terminal;
    }
    local->useHole(boxIndex(p));
  }
  return leans;
}

constexpr int kGroupReachSquared = 3;

bool covers(const Beam& beam, int edge) {
  return beam.start <= edge && beam.last() >= edge + 1;
}

}  // namespace

std::vector<std::pair<int, int>> Layout::terminalsAt(int junction) const {
  std::vector<std::pair<int, int>> terminals;
  const auto add = [&](int run, std::size_t beam) {
    const std::pair<int, int> terminal{run, static_cast<int>(beam)};
    if (std::find(terminals.begin(), terminals.end(), terminal) == terminals.end() &&
        terminals.size() < LocalProblem::kMaxTerminals) {
      terminals.push_back(terminal);
    }
  };
  for (const guide::Incidence& incidence : problem_->graph.junctions[at(junction)].incident) {
    const std::vector<Beam>& beams = runs_[at(incidence.run)].cover.beams;
    const int edges = problem_->graph.runs[at(incidence.run)].edgeCount();
    const int i = incidence.index;
    bool coveredBefore = i == 0;
    bool coveredAfter = i == edges;
    for (std::size_t b = 0; b < beams.size(); ++b) {
      if (beams[b].start <= i && beams[b].last() >= i) {
        add(incidence.run, b);
        coveredBefore = coveredBefore || covers(beams[b], i - 1);
        coveredAfter = coveredAfter || covers(beams[b], i);
      }
    }
    for (std::size_t b = 0; b < beams.size(); ++b) {
      if ((!coveredBefore && beams[b].last() == i - 1) ||
          (!coveredAfter && beams[b].start == i + 1)) {
        add(incidence.run, b);
      }
    }
  }
  return terminals;
}

void Layout::fillRun(const RunView& view) {
  const guide::GuideRun& run = problem_->graph.runs[at(view.run)];
  const Cover& cover = runs_[at(view.run)].cover;
  const Cell axisStep = unitCell(cover.axis);
  // Parts of the sketch that do not touch stay apart: no pin may enter another piece's beams.
  const bool foreign = run.piece != localPiece_;
  for (std::size_t b = 0; b < cover.beams.size(); ++b) {
    const Beam& beam = cover.beams[b];
    if (static_cast<double>(beam.solidLast()) < view.low ||
        static_cast<double>(beam.solidStart()) > view.high) {
      continue;
    }
    const PinnedNodes pinned(run, cover, b);
    int terminal = -1;
    for (std::size_t t = 0;
         t < localTerminals_.size() && (allTerminals_ || view.incidentIndex >= 0);
         ++t) {
      if (localTerminals_[t] == std::pair<int, int>{view.run, static_cast<int>(b)}) {
        terminal = static_cast<int>(t);
      }
    }
    const Cell shift = scaled(beam.layer, axisStep);
    if (beam.site >= 0) {
      fillFrame(view, beam, pinned.before, pinned.after);
      continue;
    }
    // The corner of a bent beam is one hole: the arm on the lower run brings it.
    const bool second = beam.mate >= 0 && beam.mate < view.run;
    const int corner = second ? cornerIndex(problem_->graph, view.run, beam.mate) : -2;
    if (view.aligned) {
      for (int i = std::max(beam.start, static_cast<int>(view.low) - 1);
           i <= std::min(beam.last(), static_cast<int>(view.high) + 1);
           ++i) {
        const Cell cell = view.base + scaled(i, view.step) + shift;
        if (inBox(cell) && i != corner) {
          local_.addHole({cell, cover.axis, terminal, foreign || pinned.has(i)});
        }
      }
      if (beam.tail != 0) {
        const int end = beam.tail < 0 ? beam.solidStart() : beam.solidLast();
        const Cell cell = view.base + scaled(end, view.step) + shift;
        if (inBox(cell)) {
          local_.block(boxIndex(cell));
        }
      }
      continue;
    }
    const std::size_t axisPlace = run.axes.front() == cover.axis ? 0 : 1;
    const auto first = static_cast<double>(beam.solidStart());
    const auto last = static_cast<double>(beam.solidLast());
    for (const Shadow& shadow : view.shadows[axisPlace][at(beam.layer + guide::kMaxLayer)]) {
      if (first < shadow.high && last > shadow.low) {
        local_.block(shadow.cell);
      }
    }
    for (const auto& [i, nodeCell] : view.onLattice) {
      const Cell cell = nodeCell + shift;
      if (beam.start <= i && beam.last() >= i && i != corner && inBox(cell)) {
        local_.addHole({cell, cover.axis, terminal, foreign || pinned.has(i)});
      }
    }
  }
}

bool Layout::fillOthers(int junction) {
  const LocalView& view = problem_->views[at(junction)];
  bool leans = false;
  for (const JunctionView& other : view.junctions) {
    fillSpacersOf(other);
    for (const PlacedMechanism& placed : junctions_[at(other.junction)].connection.mechanisms) {
      leans = enterMechanism(&local_, table().oriented(placed.oriented), placed, other) || leans;
    }
  }
  for (const int cell : view.forbidden) {
    if (local_.holeAt(cell) == nullptr) {
      local_.block(cell);
    }
  }
  return leans;
}

//! Enters what joins the beams of the junction itself already.
void Layout::fillOwn(int junction) {
  JunctionView self;
  self.junction = junction;
  self.aligned = true;
  fillSpacersOf(self);
  for (const PlacedMechanism& placed : junctions_[at(junction)].connection.mechanisms) {
    enterMechanism(&local_, table().oriented(placed.oriented), placed, self);
  }
}

//! A neighbouring junction's spacers; beams in their cells are that junction's trouble.
void Layout::fillSpacersOf(const JunctionView& other) {
  for (const Spacer& spacer : junctions_[at(other.junction)].spacers) {
    const Cell own = scaled(spacer.layer, unitCell(spacer.axis));
    if (!other.aligned) {
      local_.blockAround(lattice::toVec3(own) + other.offset);
      continue;
    }
    const Cell cell = own + other.shift;
    if (inBox(cell) && local_.holeAt(boxIndex(cell)) == nullptr) {
      local_.block(boxIndex(cell));
    }
  }
}

//! Spacers whose places are free are joined as beams are; the gaps of others stay.
void Layout::fillSpacers(JunctionState* state) {
  std::vector<Spacer> placed;
  for (const Spacer& spacer : state->spacers) {
    const Cell cell = scaled(spacer.layer, unitCell(spacer.axis));
    if (local_.terminals == LocalProblem::kMaxTerminals ||
        local_.holeAt(boxIndex(cell)) != nullptr || local_.blocked(boxIndex(cell))) {
      ++state->gaps;
      continue;
    }
    local_.addHole({cell, spacer.axis, local_.terminals, false});
    ++local_.terminals;
    placed.push_back(spacer);
  }
  state->spacers = placed;
}

bool Layout::fillProblem(int junction) {
  const guide::Junction& guideJunction = problem_->graph.junctions[at(junction)];
  local_.clear();
  localPiece_ = problem_->graph.runs[at(guideJunction.incident.front().run)].piece;
  local_.terminals = static_cast<int>(localTerminals_.size());
  // Off-lattice beams first: their shadows must not cover the holes of beams on the lattice.
  for (const bool aligned : {false, true}) {
    for (const RunView& view : problem_->views[at(junction)].runs) {
      if (view.aligned == aligned && !runs_[at(view.run)].cover.beams.empty()) {
        fillRun(view);
      }
    }
  }
  fillAxles(junction);
  local_.isJoint = guideJunction.joint >= 0;
  const bool leans = fillOthers(junction);
  for (std::size_t a = 0; a < localTerminals_.size(); ++a) {
    for (std::size_t b = a + 1; b < localTerminals_.size(); ++b) {
      const auto [runA, beamA] = localTerminals_[a];
      const auto [runB, beamB] = localTerminals_[b];
      if (beamA < 0 || beamB < 0) {
        continue;
      }
      if (isOneBeam(runA,
                    runs_[at(runA)].cover.beams[at(beamA)],
                    runB,
                    runs_[at(runB)].cover.beams[at(beamB)])) {
        local_.join(static_cast<int>(a), static_cast<int>(b));
      }
      if (runA == runB && (beamA - beamB == 1 || beamB - beamA == 1)) {
        const std::vector<Beam>& beams = runs_[at(runA)].cover.beams;
        const guide::GuideRun& run = problem_->graph.runs[at(runA)];
        const InlinePins pins =
            inlinePins(run, beams[at(std::min(beamA, beamB))], beams[at(std::max(beamA, beamB))]);
        if (pins.count > 0) {
          local_.join(static_cast<int>(a), static_cast<int>(b));
        }
      }
    }
  }
  if (guideJunction.joint >= 0) {
    const guide::GuideJoint& joint = problem_->graph.joints[at(guideJunction.joint)];
    local_.jointAxis = joint.axis;
    for (std::size_t t = 0; t < localTerminals_.size(); ++t) {
      for (std::size_t g = 0; g < joint.runGroups.size(); ++g) {
        const std::vector<int>& runs = joint.runGroups[g];
        if (std::find(runs.begin(), runs.end(), localTerminals_[t].first) != runs.end()) {
          local_.group[t] = static_cast<std::int8_t>(g);
        }
      }
    }
  }
  joinOnAxles(junction);
  if (problem_->closeGroups) {
    limitToGroup(junction);
  }
  return leans;
}

//! Takes all holes out of use that are further than sqrt(3) from the junction's node and from the
//! nodes at the ends of the uncovered edges beside it.
void Layout::limitToGroup(int junction) {
  std::vector<Cell> group{{0, 0, 0}};
  for (const RunView& view : problem_->views[at(junction)].runs) {
    const int edges = problem_->graph.runs[at(view.run)].edgeCount();
    const std::vector<Beam>& beams = runs_[at(view.run)].cover.beams;
    const auto bare = [&](int edge) {
      return edge >= 0 && edge < edges &&
             std::none_of(
                 beams.begin(), beams.end(), [&](const Beam& beam) { return covers(beam, edge); });
    };
    for (const int way : {-1, 1}) {
      int i = view.incidentIndex;
      while (view.aligned && i >= 0 && bare(way < 0 ? i - 1 : i)) {
        i += way;
        group.push_back(scaled(i - view.incidentIndex, view.step));
      }
    }
  }
  if (group.size() == 1) {
    return;  // a stack of beams that cover all edges: one pin along it
  }
  for (const LocalHole& hole : local_.holes()) {
    const bool inReach = std::any_of(group.begin(), group.end(), [&](Cell node) {
      const Cell d = hole.at - node;
      return d.x * d.x + d.y * d.y + d.z * d.z <= kGroupReachSquared;
    });
    if (!inReach) {
      local_.useHole(boxIndex(hole.at));
    }
  }
}

//! The usual case in a plane, without a search: all beams stacked without a gap, one pin through
//! them.
bool Layout::plainStack(int junction, Connection* connection) const {
  const std::size_t count = localTerminals_.size();
  if (count < 2 || count > 3) {
    return false;
  }
  const Axis axis = runs_[at(localTerminals_.front().first)].cover.axis;
  int low = guide::kMaxLayer + 1;
  unsigned layers = 0;
  for (const auto& [run, b] : localTerminals_) {
    const Beam& beam = runs_[at(run)].cover.beams[at(b)];
    int index = -1;
    for (const guide::Incidence& incidence : problem_->graph.junctions[at(junction)].incident) {
      index = incidence.run == run ? incidence.index : index;
    }
    if (runs_[at(run)].cover.axis != axis || !beam.hasHoleAt(index)) {
      return false;
    }
    low = std::min(low, beam.layer);
    layers |= 1U << static_cast<unsigned>(beam.layer + guide::kMaxLayer);
  }
  if ((layers >> static_cast<unsigned>(low + guide::kMaxLayer)) != (1U << count) - 1U) {
    return false;
  }
  const Cell step = unitCell(axis);
  const Cell bottom = scaled(low, step);
  for (const JunctionView& other : problem_->views[at(junction)].junctions) {
    for (const PlacedMechanism& placed : junctions_[at(other.junction)].connection.mechanisms) {
      for (const MechanismCell& cell : table().oriented(placed.oriented).shape.cells) {
        const Cell p = cell.at + placed.at + other.shift;
        const Cell onAxis = p - scaled(p[lattice::index(axis)], step);
        if (other.aligned && onAxis == Cell{}) {
          return false;
        }
      }
    }
  }
  for (const mechanisms::TableEntry& entry :
       table().between(scaled(static_cast<int>(count) - 1, step), axis, axis)) {
    const OrientedMechanism& m = table().oriented(entry.mechanism);
    if (m.heads == static_cast<int>(count) && m.shape.cells.size() == count) {
      const Cell head = m.shape.cells[at(entry.headA)].at;
      connection->mechanisms = {{entry.mechanism, bottom - head}};
      connection->cost = m.cost;
      connection->failed = 0;
      return true;
    }
  }
  return false;
}

void Layout::solveJunction(int junction) {
  JunctionState& state = junctions_[at(junction)];
  countStack(junction, &state);
  localTerminals_ = terminalsAt(junction);
  const bool axle = onAxle(junction);
  if (axle) {
    addAxleTerminals(junction);
  }
  if (localTerminals_.size() < 2 ||
      (!axle && state.spacers.empty() && plainStack(junction, &state.connection))) {
    return;
  }
  state.leans = fillProblem(junction);
  state.loose = localLoose_;
  fillSpacers(&state);
  state.connection = solver_->solve(local_);
}

}  // namespace liftarm::layout
