#include "sketch/crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <tuple>

#include "base/hash.h"

namespace liftarm::sketch {

namespace {

using lattice::Vec3;

// Bounds the time on drawings that crowd thousands of lines into one module.
constexpr std::int64_t kMaxComparisons = 20'000'000;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

struct Edge {
  int run = -1;
  int index = -1;
  int fromNode = -1;
  int toNode = -1;
  Vec3 from;
  Vec3 to;
};

struct CellEntry {
  std::uint64_t cell = 0;
  int edge = -1;
};

std::vector<Edge> edgesOf(const Arrangement& arrangement) {
  std::vector<Edge> edges;
  for (std::size_t r = 0; r < arrangement.runs.size(); ++r) {
    const std::vector<int>& nodes = arrangement.runs[r].nodes;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
      edges.push_back({static_cast<int>(r),
                       static_cast<int>(i),
                       nodes[i],
                       nodes[i + 1],
                       arrangement.nodes[at(nodes[i])].position,
                       arrangement.nodes[at(nodes[i + 1])].position});
    }
  }
  return edges;
}

//! Cells are centred on whole numbers, so that lines on the lattice stay clear of their borders.
std::int64_t cellOf(double coordinate) {
  return static_cast<std::int64_t>(std::floor(coordinate + 0.5));
}

//! The cells from `low` to `high` along each axis.
struct CellRange {
  std::array<std::int64_t, 3> low{};
  std::array<std::int64_t, 3> high{};
};

CellRange cellsAround(const Edge& edge) {
  CellRange range;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = edge.from[axis];
    const double b = edge.to[axis];
    range.low[at(axis)] = cellOf(std::min(a, b) - kSamePoint);
    range.high[at(axis)] = cellOf(std::max(a, b) + kSamePoint);
  }
  return range;
}

std::vector<CellEntry> sortIntoCells(const std::vector<Edge>& edges) {
  std::vector<CellEntry> entries;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const CellRange cells = cellsAround(edges[e]);
    for (std::int64_t x = cells.low[0]; x <= cells.high[0]; ++x) {
      for (std::int64_t y = cells.low[1]; y <= cells.high[1]; ++y) {
        const std::uint64_t column =
            base::mixHash(static_cast<std::uint64_t>(x), static_cast<std::uint64_t>(y));
        for (std::int64_t z = cells.low[2]; z <= cells.high[2]; ++z) {
          entries.push_back(
              {base::mixHash(column, static_cast<std::uint64_t>(z)), static_cast<int>(e)});
        }
      }
    }
  }
  std::sort(entries.begin(), entries.end(), [](const CellEntry& a, const CellEntry& b) {
    return std::tie(a.cell, a.edge) < std::tie(b.cell, b.edge);
  });
  return entries;
}

double clampToUnit(double value) {
  return std::min(1.0, std::max(0.0, value));
}

//! Where parallel edges on one line overlap, the middle of what they share.
std::optional<Vec3> overlapOf(const Edge& a, const Edge& b) {
  const Vec3 along = a.to - a.from;  // length 1
  const Vec3 offset = b.from - a.from;
  const Vec3 aside = offset - lattice::dot(offset, along) * along;
  if (lattice::length(aside) > kSamePoint) {
    return std::nullopt;
  }
  const double first = lattice::dot(offset, along);
  const double second = lattice::dot(b.to - a.from, along);
  const double low = std::max(0.0, std::min(first, second));
  const double high = std::min(1.0, std::max(first, second));
  if (high - low <= kSamePoint) {
    return std::nullopt;
  }
  return a.from + (0.5 * (low + high)) * along;
}

//! The point where two edges come within kSamePoint of each other.
std::optional<Vec3> meetingPoint(const Edge& a, const Edge& b) {
  constexpr double kParallel = 1e-9;  // squared sine of the angle between unit edges
  const Vec3 alongA = a.to - a.from;
  const Vec3 alongB = b.to - b.from;
  const Vec3 offset = a.from - b.from;
  const double aa = lattice::dot(alongA, alongA);
  const double bb = lattice::dot(alongB, alongB);
  const double ab = lattice::dot(alongA, alongB);
  const double determinant = aa * bb - ab * ab;
  if (determinant < kParallel) {
    return overlapOf(a, b);
  }
  const double aOffset = lattice::dot(alongA, offset);
  const double bOffset = lattice::dot(alongB, offset);
  double shareA = clampToUnit((ab * bOffset - aOffset * bb) / determinant);
  const double shareB = clampToUnit((ab * shareA + bOffset) / bb);
  shareA = clampToUnit((ab * shareB - aOffset) / aa);
  const Vec3 pointA = a.from + shareA * alongA;
  const Vec3 pointB = b.from + shareB * alongB;
  if (lattice::length(pointA - pointB) > kSamePoint) {
    return std::nullopt;
  }
  return pointA;
}

bool shareNode(const Edge& a, const Edge& b) {
  return a.fromNode == b.fromNode || a.fromNode == b.toNode || a.toNode == b.fromNode ||
         a.toNode == b.toNode;
}

struct Meeting {
  OffNodeCrossing crossing;
  int edgeA = -1;
  int edgeB = -1;
};

//! \return False when enough has been found or tried.
bool compareCell(const std::vector<Edge>& edges,
                 const std::vector<CellEntry>& entries,
                 std::pair<std::size_t, std::size_t> range,
                 std::int64_t& comparisons,
                 std::vector<Meeting>& meetings) {
  for (std::size_t i = range.first; i < range.second; ++i) {
    for (std::size_t j = i + 1; j < range.second; ++j) {
      const Edge& a = edges[at(entries[i].edge)];
      const Edge& b = edges[at(entries[j].edge)];
      if (++comparisons > kMaxComparisons || meetings.size() >= 8 * kMaxCrossings) {
        return false;
      }
      if (a.run == b.run || shareNode(a, b)) {
        continue;
      }
      // Entries are sorted by edge and edges by run, so a.run < b.run.
      if (const std::optional<Vec3> point = meetingPoint(a, b)) {
        meetings.push_back({{a.run, b.run, *point}, a.index, b.index});
      }
    }
  }
  return true;
}

}  // namespace

std::vector<OffNodeCrossing> findOffNodeCrossings(const Arrangement& arrangement) {
  const std::vector<Edge> edges = edgesOf(arrangement);
  const std::vector<CellEntry> entries = sortIntoCells(edges);
  std::vector<Meeting> meetings;
  std::int64_t comparisons = 0;
  std::size_t begin = 0;
  while (begin < entries.size()) {
    std::size_t end = begin + 1;
    while (end < entries.size() && entries[end].cell == entries[begin].cell) {
      ++end;
    }
    if (!compareCell(edges, entries, {begin, end}, comparisons, meetings)) {
      break;
    }
    begin = end;
  }
  // A meeting near the border of cells, or at the end of two edges, was found several times.
  std::sort(meetings.begin(), meetings.end(), [](const Meeting& a, const Meeting& b) {
    return std::tie(a.crossing.runA, a.crossing.runB, a.edgeA, a.edgeB) <
           std::tie(b.crossing.runA, b.crossing.runB, b.edgeA, b.edgeB);
  });
  std::vector<OffNodeCrossing> crossings;
  for (const Meeting& meeting : meetings) {
    const OffNodeCrossing& next = meeting.crossing;
    const bool isNew = crossings.empty() || crossings.back().runA != next.runA ||
                       crossings.back().runB != next.runB;
    if (isNew && crossings.size() < kMaxCrossings) {
      crossings.push_back(next);
    }
  }
  return crossings;
}

}  // namespace liftarm::sketch
