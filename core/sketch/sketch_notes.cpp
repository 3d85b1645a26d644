#include "sketch/sketch_notes.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "sketch/arrangement.h"
#include "sketch/closings.h"
#include "sketch/crossings.h"
#include "sketch/json_fields.h"
#include "sketch/json_text.h"
#include "sketch/piece_gaps.h"

namespace liftarm::sketch {

namespace {

using lattice::Vec3;

constexpr double kWorthTelling = 1e-3;  // modules: less is how decimal numbers are written
constexpr double kWhole = 1e-6;

std::string modulesText(double modules) {
  const std::string number = shortNumber(modules);
  return number + (number == "1" ? " module (" : " modules (") +
         shortNumber(modules * lattice::kMillimetresPerModule) + " mm)";
}

std::string lineName(int line) {
  return elementPlace("lines", static_cast<std::size_t>(line));
}

int lineOf(const Arrangement& arrangement, int run, int edge = 0) {
  return arrangement.runs[static_cast<std::size_t>(run)]
      .edges[static_cast<std::size_t>(edge)]
      .lines.front();
}

//! Lines moved by a vector, as they were drawn and then moved.
std::vector<MendedLine> movedLines(const Reading& reading,
                                   const std::vector<int>& lines,
                                   const Vec3& by) {
  std::vector<MendedLine> moved;
  for (const int line : lines) {
    const Line& read = reading.sketch.lines[static_cast<std::size_t>(line)];
    moved.push_back({line, read.from + by, read.to + by});
  }
  return moved;
}

//! The lines that make up a run, or all that hang together with it.
std::vector<int> linesOf(const Arrangement& arrangement, int run, bool wholePiece) {
  std::set<int> lines;
  const int piece = arrangement.runs[static_cast<std::size_t>(run)].piece;
  for (std::size_t r = 0; r < arrangement.runs.size(); ++r) {
    if (wholePiece ? arrangement.runs[r].piece == piece : static_cast<int>(r) == run) {
      for (const ArrangedEdge& edge : arrangement.runs[r].edges) {
        lines.insert(edge.lines.begin(), edge.lines.end());
      }
    }
  }
  return {lines.begin(), lines.end()};
}

//! What goes along when run B is moved to where it touches run A: all that hangs together with it,
//! unless run A does so too.
std::vector<int> linesToMove(const Arrangement& arrangement, int runA, int runB) {
  const auto pieceOf = [&](int run) {
    return arrangement.runs[static_cast<std::size_t>(run)].piece;
  };
  return linesOf(arrangement, runB, pieceOf(runA) != pieceOf(runB));
}

//! A run's node that is nearest to a point.
Vec3 nearestNode(const Arrangement& arrangement, int run, const Vec3& point) {
  const std::vector<int>& nodes = arrangement.runs[static_cast<std::size_t>(run)].nodes;
  const auto at = [&](int node) {
    return arrangement.nodes[static_cast<std::size_t>(node)].position;
  };
  return at(*std::min_element(nodes.begin(), nodes.end(), [&](int a, int b) {
    return lattice::length(at(a) - point) < lattice::length(at(b) - point);
  }));
}

void addMoved(const Reading& reading, std::vector<Note>& notes) {
  Note note{"moved", {}, {}, {}, {}};
  double most = 0.0;
  int moved = 0;
  for (std::size_t i = 0; i < reading.drawn.size(); ++i) {
    const Line& drawn = reading.drawn[i];
    const Line& read = reading.sketch.lines[i];
    if (lattice::length(drawn.from - read.from) + lattice::length(drawn.to - read.to) > 0.0) {
      note.mend.push_back({static_cast<int>(i), read.from, read.to});
    }
    for (const auto& [before, after, end] :
         {std::tuple{drawn.from, read.from, "from"}, std::tuple{drawn.to, read.to, "to"}}) {
      const double distance = lattice::length(after - before);
      moved += distance >= kWorthTelling ? 1 : 0;
      if (distance > most) {
        most = distance;
        note.at = after;
        note.lines = {static_cast<int>(i)};
        note.message = memberPlace(elementPlace("lines", i), end) + " was moved by " +
                       modulesText(distance) + ", from " + pointText(before) + " to " +
                       pointText(after) + ", so that lines have whole lengths";
      }
    }
  }
  if (most >= kWorthTelling) {
    note.message += "; " + std::to_string(moved) + " of " +
                    std::to_string(2 * reading.drawn.size()) + " line ends were moved";
    notes.push_back(note);
  }
}

void addOpen(const Reading& reading, std::vector<Note>& notes) {
  if (reading.sketch.residual < kWorthTelling) {
    return;
  }
  const auto offOf = [](const Line& line) {
    return std::abs(lattice::length(line.to - line.from) - line.length);
  };
  const std::vector<Line>& lines = reading.sketch.lines;
  const auto worst =
      std::max_element(lines.begin(), lines.end(), [&](const Line& a, const Line& b) {
        return offOf(a) < offOf(b);
      });
  const auto index = static_cast<std::size_t>(worst - lines.begin());
  const Line& drawn = reading.drawn[index];
  notes.push_back(
      {"open",
       elementPlace("lines", index) + " is " + shortNumber(lattice::length(drawn.to - drawn.from)) +
           " modules long as drawn; its length of " + std::to_string(worst->length) +
           " does not close with the lines that it touches, and " + modulesText(offOf(*worst)) +
           " are left to the play of the pins" + closingsText(drawn),
       0.5 * (worst->from + worst->to),
       {static_cast<int>(index)},
       {}});
}

void addNear(const Reading& reading, const Arrangement& arrangement, std::vector<Note>& notes) {
  const std::vector<NearMiss> misses = findNearMisses(arrangement);
  for (std::size_t i = 0; i < misses.size() && i < kMostNotes; ++i) {
    const NearMiss& miss = misses[i];
    const int a = lineOf(arrangement, miss.runA, miss.edgeA);
    const int b = lineOf(arrangement, miss.runB, miss.edgeB);
    // Nodes are brought together: where lines only cross, no pin joins them.
    const Vec3 shift = nearestNode(arrangement, miss.runA, miss.pointA) -
                       nearestNode(arrangement, miss.runB, miss.pointB);
    notes.push_back({"near",
                     lineName(a) + " and " + lineName(b) + " come within " +
                         modulesText(miss.gap()) + " of each other at " + pointText(miss.pointA) +
                         " and do not touch, so nothing joins them there; moving " + lineName(b) +
                         " by " + pointText(shift) + " would",
                     miss.pointA,
                     {a, b},
                     movedLines(reading, linesToMove(arrangement, miss.runA, miss.runB), shift)});
  }
}

//! The smallest shift of run B that brings nodes of both runs together where they cross.
Vec3 mendingShift(const Arrangement& arrangement, const OffNodeCrossing& crossing) {
  const Run& a = arrangement.runs[static_cast<std::size_t>(crossing.runA)];
  const Run& b = arrangement.runs[static_cast<std::size_t>(crossing.runB)];
  const auto startOf = [&](const Run& run) {
    return arrangement.nodes[static_cast<std::size_t>(run.nodes.front())].position;
  };
  const auto offNode = [](double along) { return std::round(along) - along; };
  if (std::abs(lattice::dot(a.direction, b.direction)) > 1.0 - kWhole) {
    return offNode(lattice::dot(startOf(b) - startOf(a), a.direction)) * a.direction;
  }
  const double onA = lattice::dot(crossing.point - startOf(a), a.direction);
  const double onB = lattice::dot(crossing.point - startOf(b), b.direction);
  return offNode(onA) * a.direction - offNode(onB) * b.direction;
}

void addCrossings(const Reading& reading,
                  const Arrangement& arrangement,
                  std::vector<Note>& notes) {
  const std::vector<OffNodeCrossing>& crossings = arrangement.offNodeCrossings;
  for (std::size_t i = 0; i < crossings.size() && i < kMostNotes; ++i) {
    const OffNodeCrossing& crossing = crossings[i];
    const int a = lineOf(arrangement, crossing.runA);
    const int b = lineOf(arrangement, crossing.runB);
    const Vec3 shift = mendingShift(arrangement, crossing);
    const bool mends = lattice::length(shift) >= kWorthTelling;
    const std::vector<int> lines = linesToMove(arrangement, crossing.runA, crossing.runB);
    notes.push_back({"crossing",
                     lineName(a) + " and " + lineName(b) + " cross at " +
                         pointText(crossing.point) +
                         " between their nodes, where no pin can join them" +
                         (mends ? "; moving " + lineName(b) + " by " + pointText(shift) +
                                      " would put nodes of both there"
                                : std::string()),
                     crossing.point,
                     {a, b},
                     mends ? movedLines(reading, lines, shift) : std::vector<MendedLine>{}});
  }
}

//! Whether a line between two nodes would be a legal one.
bool lineFits(const PieceGap& gap) {
  const Vec3 span = gap.to - gap.from;
  const double length = lattice::length(span);
  const double smallest = std::min({std::abs(span.x), std::abs(span.y), std::abs(span.z)});
  return length > 0.5 && std::abs(length - std::round(length)) < kWhole && smallest < kWhole;
}

//! What would join two nodes: a line where one fits, else a shift of the piece.
std::string joiningText(const PieceGap& gap) {
  const Vec3 span = gap.to - gap.from;
  if (lineFits(gap)) {
    return "a line between them, " + shortNumber(std::round(lattice::length(span))) +
           " long, would join them";
  }
  return "moving the one by " + pointText(span) + " would join them";
}

void addPieces(const Reading& reading, const Arrangement& arrangement, std::vector<Note>& notes) {
  if (arrangement.pieces < 2) {
    return;
  }
  const int first = lineOf(arrangement, 0);
  notes.push_back(
      {"pieces",
       "the sketch is " + std::to_string(arrangement.pieces) +
           " pieces that nothing joins; each is built on its own",
       arrangement.nodes[static_cast<std::size_t>(arrangement.runs.front().nodes.front())].position,
       {first},
       {}});
  for (const PieceGap& gap : findPieceGaps(arrangement, kMostNotes)) {
    const int line = lineOf(arrangement, gap.run);
    const int other = lineOf(arrangement, gap.otherRun);
    notes.push_back(
        {"pieces",
         "the piece of " + lineName(line) + " is " +
             modulesText(lattice::length(gap.to - gap.from)) + " from the piece of " +
             lineName(other) + ", from node " + pointText(gap.from) + " to node " +
             pointText(gap.to) + "; " + joiningText(gap),
         gap.from,
         {line, other},
         lineFits(gap)
             ? std::vector<MendedLine>{{-1, gap.from, gap.to}}
             : movedLines(reading, linesOf(arrangement, gap.run, true), gap.to - gap.from)});
  }
}

}  // namespace

std::vector<Note> notesOn(const Reading& reading) {
  std::vector<Note> notes;
  addMoved(reading, notes);
  addOpen(reading, notes);
  const Arrangement arrangement = arrange(reading.sketch);
  addNear(reading, arrangement, notes);
  addCrossings(reading, arrangement, notes);
  addPieces(reading, arrangement, notes);
  return notes;
}

}  // namespace liftarm::sketch
