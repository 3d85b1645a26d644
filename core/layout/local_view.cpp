#include "layout/local_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "lattice/whole_cell.h"
#include "layout/beam.h"

namespace liftarm::layout {

namespace {

using lattice::Axis;
using lattice::Cell;
using lattice::Vec3;

constexpr double kNearLattice = 2e-3;

std::optional<Cell> wholeCell(Vec3 p) {
  return lattice::wholeCell(p, kNearLattice);
}

//! Range of node indices in which the run's middle line is within `reach` of the origin on all
//! axes.
std::pair<double, double> windowOf(Vec3 first, Vec3 direction, double reach) {
  double low = -1e9;
  double high = 1e9;
  for (int i = 0; i < 3; ++i) {
    if (std::abs(direction[i]) < 1e-9) {
      if (std::abs(first[i]) > reach) {
        return {0.0, -1.0};
      }
      continue;
    }
    const double t0 = (-reach - first[i]) / direction[i];
    const double t1 = (reach - first[i]) / direction[i];
    low = std::max(low, std::min(t0, t1));
    high = std::min(high, std::max(t0, t1));
  }
  return {low, high};
}

//! Range of places along a line that a disk of radius kBeamRadius may not be at without entering
//! the square body of a connector: where the line crosses the square grown by that radius.
struct Crossing {
  double low = 1e9;
  double high = -1e9;

  void add(double from, double to) {
    if (from < to) {
      low = std::min(low, from);
      high = std::max(high, to);
    }
  }
};

struct Flat {
  double u = 0.0;
  double v = 0.0;
};

//! The line p + t * d inside the rectangle [-a, a] x [-b, b].
void crossRectangle(Flat p, Flat d, double a, double b, Crossing* crossing) {
  double from = -1e9;
  double to = 1e9;
  for (const auto& [start, step, half] :
       {std::array<double, 3>{p.u, d.u, a}, std::array<double, 3>{p.v, d.v, b}}) {
    if (std::abs(step) < 1e-9) {
      if (std::abs(start) >= half) {
        return;
      }
      continue;
    }
    const double first = (-half - start) / step;
    const double second = (half - start) / step;
    from = std::max(from, std::min(first, second));
    to = std::min(to, std::max(first, second));
  }
  crossing->add(from, to);
}

//! The square grown by a radius is two rectangles and four disks at its corners; d has unit length.
Crossing crossBody(Flat p, Flat d) {
  constexpr double kHalf = kConnectorHalfWidth;
  constexpr double kRadius = kBeamRadius - kContactTolerance;
  Crossing crossing;
  crossRectangle(p, d, kHalf + kRadius, kHalf, &crossing);
  crossRectangle(p, d, kHalf, kHalf + kRadius, &crossing);
  for (const double su : {-kHalf, kHalf}) {
    for (const double sv : {-kHalf, kHalf}) {
      const Flat q{p.u - su, p.v - sv};
      const double along = -(q.u * d.u + q.v * d.v);
      const double apart = q.u * q.u + q.v * q.v - along * along;
      if (apart < kRadius * kRadius) {
        const double half = std::sqrt(kRadius * kRadius - apart);
        crossing.add(along - half, along + half);
      }
    }
  }
  return crossing;
}

//! Cells that a beam on this line (first hole of node 0 at `first`, on its layer) blocks, and
//! where.
std::vector<Shadow> shadowsOf(Vec3 first, Vec3 direction, Axis axis) {
  std::vector<Shadow> shadows;
  const int k = lattice::index(axis);
  const int u = (k + 1) % 3;
  const int v = (k + 2) % 3;
  for (int x = -kBoxRadius; x <= kBoxRadius; ++x) {
    for (int y = -kBoxRadius; y <= kBoxRadius; ++y) {
      for (int z = -kBoxRadius; z <= kBoxRadius; ++z) {
        const Cell cell{x, y, z};
        const Vec3 toLine = first - lattice::toVec3(cell);
        if (std::abs(toLine[k]) >= 1.0 - kContactTolerance) {
          continue;
        }
        const Crossing crossing = crossBody({toLine[u], toLine[v]}, {direction[u], direction[v]});
        if (crossing.low < crossing.high) {
          shadows.push_back({boxIndex(cell), crossing.low, crossing.high});
        }
      }
    }
  }
  return shadows;
}

RunView viewOfRun(const guide::GuidingGraph& graph, int runId, Vec3 origin) {
  const guide::GuideRun& run = graph.runs[static_cast<std::size_t>(runId)];
  const Vec3 first = graph.nodes[static_cast<std::size_t>(run.nodes.front())] - origin;
  RunView view;
  view.run = runId;
  const auto [low, high] =
      windowOf(first, run.direction, kBoxRadius + guide::kMaxLayer + kBeamReach);
  view.low = low;
  view.high = high;
  const std::optional<Cell> base = wholeCell(first);
  const std::optional<Cell> step = wholeCell(run.direction);
  if (base && step) {
    view.aligned = true;
    view.base = *base;
    view.step = *step;
    return view;
  }
  for (int i = -1; i <= static_cast<int>(run.nodes.size()); ++i) {
    const Vec3 p = first + static_cast<double>(i) * run.direction;
    const std::optional<Cell> cell = wholeCell(p);
    if (cell && static_cast<double>(i) >= low - 1.0 && static_cast<double>(i) <= high + 1.0) {
      view.onLattice.emplace_back(i, *cell);
    }
  }
  for (std::size_t a = 0; a < run.axes.size() && a < 2; ++a) {
    for (int layer = -guide::kMaxLayer; layer <= guide::kMaxLayer; ++layer) {
      const Vec3 shifted = first + static_cast<double>(layer) * lattice::unitVector(run.axes[a]);
      view.shadows[a][static_cast<std::size_t>(layer + guide::kMaxLayer)] =
          shadowsOf(shifted, run.direction, run.axes[a]);
    }
  }
  return view;
}

LocalView viewOfJunction(const guide::GuidingGraph& graph, const guide::Junction& junction) {
  const Vec3 origin = graph.nodes[static_cast<std::size_t>(junction.node)];
  LocalView view;
  for (const int run : junction.nearRuns) {
    RunView runView = viewOfRun(graph, run, origin);
    if (runView.low > runView.high) {
      continue;
    }
    for (const guide::Incidence& incidence : junction.incident) {
      if (incidence.run == run) {
        runView.incidentIndex = incidence.index;
      }
    }
    view.runs.push_back(std::move(runView));
  }
  for (const int other : junction.nearJunctions) {
    const int node = graph.junctions[static_cast<std::size_t>(other)].node;
    JunctionView junctionView;
    junctionView.junction = other;
    junctionView.offset = graph.nodes[static_cast<std::size_t>(node)] - origin;
    const std::optional<Cell> shift = wholeCell(junctionView.offset);
    junctionView.aligned = shift.has_value();
    junctionView.shift = shift.value_or(Cell{});
    view.junctions.push_back(junctionView);
  }
  for (int x = -kBoxRadius; x <= kBoxRadius; ++x) {
    for (int y = -kBoxRadius; y <= kBoxRadius; ++y) {
      for (int z = -kBoxRadius; z <= kBoxRadius; ++z) {
        const Cell cell{x, y, z};
        if (forbiddenAt(graph, origin + lattice::toVec3(cell))) {
          view.forbidden.push_back(boxIndex(cell));
        }
      }
    }
  }
  return view;
}

}  // namespace

bool forbiddenAt(const guide::GuidingGraph& graph, Vec3 point) {
  constexpr double kSlack = 0.05;
  if (graph.ground && point.z < *graph.ground - kSlack) {
    return true;
  }
  return std::any_of(graph.keepOut.begin(), graph.keepOut.end(), [&](const sketch::KeepOut& box) {
    for (int i = 0; i < 3; ++i) {
      if (point[i] < box.min[i] - kSlack || point[i] > box.max[i] + kSlack) {
        return false;
      }
    }
    return true;
  });
}

std::vector<LocalView> buildLocalViews(const guide::GuidingGraph& graph) {
  std::vector<LocalView> views;
  views.reserve(graph.junctions.size());
  for (const guide::Junction& junction : graph.junctions) {
    views.push_back(viewOfJunction(graph, junction));
  }
  return views;
}

}  // namespace liftarm::layout
