#include "sketch/crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <tuple>

#include "base/hash.h"
#include "base/index.h"

namespace liftarm::sketch {

namespace {

using base::at;
using lattice::Vec3;

// Bounds the time on drawings that crowd thousands of lines into one module.
constexpr std::int64_t kMaxComparisons = 20'000'000;

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

CellRange cellsAround(const Edge& edge, double reach) {
  CellRange range;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = edge.from[axis];
    const double b = edge.to[axis];
    range.low[at(axis)] = cellOf(std::min(a, b) - reach);
    range.high[at(axis)] = cellOf(std::max(a, b) + reach);
  }
  return range;
}

std::vector<CellEntry> sortIntoCells(const std::vector<Edge>& edges, double reach) {
  std::vector<CellEntry> entries;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const CellRange cells = cellsAround(edges[e], reach);
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

//! The points of two edges that are nearest to each other.
struct Closest {
  Vec3 a;
  Vec3 b;
  bool overlap = true;  //!< for edges on one line: they share more than an end
};

//! Of parallel edges, the middle of what lies beside each other, or their nearest ends.
Closest closestOfParallels(const Edge& a, const Edge& b) {
  const Vec3 along = a.to - a.from;  // length 1
  const double first = lattice::dot(b.from - a.from, along);
  const double second = lattice::dot(b.to - a.from, along);
  const double low = std::max(0.0, std::min(first, second));
  const double high = std::min(1.0, std::max(first, second));
  const double onA = high > low ? 0.5 * (low + high) : clampToUnit(0.5 * (low + high));
  const Vec3 pointA = a.from + onA * along;
  const Vec3 alongB = b.to - b.from;
  const double onB = clampToUnit(lattice::dot(pointA - b.from, alongB));
  return {pointA, b.from + onB * alongB, high - low > kSamePoint};
}

Closest closestPoints(const Edge& a, const Edge& b) {
  constexpr double kParallel = 1e-9;  // squared sine of the angle between unit edges
  const Vec3 alongA = a.to - a.from;
  const Vec3 alongB = b.to - b.from;
  const Vec3 offset = a.from - b.from;
  const double aa = lattice::dot(alongA, alongA);
  const double bb = lattice::dot(alongB, alongB);
  const double ab = lattice::dot(alongA, alongB);
  const double determinant = aa * bb - ab * ab;
  if (determinant < kParallel) {
    return closestOfParallels(a, b);
  }
  const double aOffset = lattice::dot(alongA, offset);
  const double bOffset = lattice::dot(alongB, offset);
  double shareA = clampToUnit((ab * bOffset - aOffset * bb) / determinant);
  const double shareB = clampToUnit((ab * shareA + bOffset) / bb);
  shareA = clampToUnit((ab * shareB - aOffset) / aa);
  return {a.from + shareA * alongA, b.from + shareB * alongB};
}

bool shareNode(const Edge& a, const Edge& b) {
  return a.fromNode == b.fromNode || a.fromNode == b.toNode || a.toNode == b.fromNode ||
         a.toNode == b.toNode;
}

//! Compares all edges of two runs without a common node that share a cell. \param meet Is called
//! with both, run A before run B, and may be called again for the same two.
template <typename Meet>
void compareNeighbours(const Arrangement& arrangement, double reach, const Meet& meet) {
  const std::vector<Edge> edges = edgesOf(arrangement);
  const std::vector<CellEntry> entries = sortIntoCells(edges, reach);
  std::int64_t comparisons = 0;
  for (std::size_t begin = 0, end = 0; begin < entries.size(); begin = end) {
    for (end = begin + 1; end < entries.size() && entries[end].cell == entries[begin].cell;) {
      ++end;
    }
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t j = i + 1; j < end; ++j) {
        // Entries are sorted by edge and edges by run, so a.run < b.run.
        const Edge& a = edges[at(entries[i].edge)];
        const Edge& b = edges[at(entries[j].edge)];
        if (++comparisons > kMaxComparisons) {
          return;
        }
        if (a.run != b.run && !shareNode(a, b) && !meet(a, b)) {
          return;
        }
      }
    }
  }
}

struct Meeting {
  OffNodeCrossing crossing;
  int edgeA = -1;
  int edgeB = -1;
};

bool shareAnyNode(const Arrangement& arrangement, int runA, int runB) {
  const std::vector<int>& nodes = arrangement.runs[at(runA)].nodes;
  return std::any_of(nodes.begin(), nodes.end(), [&](int node) {
    const auto& runs = arrangement.nodes[at(node)].runs;
    return std::any_of(
        runs.begin(), runs.end(), [&](const auto& run) { return run.first == runB; });
  });
}

}  // namespace

std::vector<OffNodeCrossing> findOffNodeCrossings(const Arrangement& arrangement) {
  std::vector<Meeting> meetings;
  compareNeighbours(arrangement, kSamePoint, [&](const Edge& a, const Edge& b) {
    const Closest closest = closestPoints(a, b);
    if (closest.overlap && lattice::length(closest.a - closest.b) <= kSamePoint) {
      meetings.push_back({{a.run, b.run, closest.a}, a.index, b.index});
    }
    return meetings.size() < 8 * kMaxCrossings;
  });
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

std::vector<NearMiss> findNearMisses(const Arrangement& arrangement) {
  std::vector<NearMiss> near;
  compareNeighbours(arrangement, kNearMiss, [&](const Edge& a, const Edge& b) {
    const Closest closest = closestPoints(a, b);
    const NearMiss miss{a.run, b.run, a.index, b.index, closest.a, closest.b};
    if (miss.gap() <= kNearMiss) {
      near.push_back(miss);
    }
    return near.size() < 8 * kMaxCrossings;
  });
  std::sort(near.begin(), near.end(), [](const NearMiss& a, const NearMiss& b) {
    return std::make_tuple(a.runA, a.runB, a.gap(), a.edgeA, a.edgeB) <
           std::make_tuple(b.runA, b.runB, b.gap(), b.edgeA, b.edgeB);
  });
  const auto last = std::unique(near.begin(), near.end(), [](const NearMiss& a, const NearMiss& b) {
    return a.runA == b.runA && a.runB == b.runB;
  });
  near.erase(last, near.end());
  // Those that touch are joined or cross, and those with a common node are near each other there.
  const auto kept = std::remove_if(near.begin(), near.end(), [&](const NearMiss& miss) {
    return miss.gap() <= kSamePoint || shareAnyNode(arrangement, miss.runA, miss.runB);
  });
  near.erase(kept, near.end());
  return near;
}

}  // namespace liftarm::sketch
