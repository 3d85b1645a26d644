#include "analysis/disassembly_moves.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "analysis/convex.h"

namespace liftarm::analysis {

namespace {

using lattice::Vec3;

constexpr int kMaxRetraction = 6;  // modules
constexpr double kUp = 0.7;        // a direction is upward from 45 degrees on
constexpr double kGap = 0.03;

Vec3 middleOf(const Box& box) {
  return 0.5 * (box.min + box.max);
}

Box boxOf(const Scene& scene, const std::vector<int>& set) {
  Box box;
  for (const int part : set) {
    box.add(scene.parts[static_cast<std::size_t>(part)].box);
  }
  return box;
}

Box moved(const Box& box, Vec3 by) {
  return {box.min + by, box.max + by};
}

//! Larger is better: upwards, then away from the middle of the rest, downwards last.
double worthOf(Vec3 direction, Vec3 outwards) {
  constexpr double kFarther = 100.0;
  double worth = lattice::dot(direction, outwards) / kFarther;
  worth += direction.z > kUp ? 2.0 : 0.0;
  worth -= direction.z < -kUp ? 2.0 : 0.0;
  return worth;
}

//! Directions from the best to the worst for a set.
std::vector<int> rankedDirections(const DisassemblyGraphs& graphs,
                                  const DisassemblyState& state,
                                  const std::vector<int>& set) {
  const Vec3 outwards =
      middleOf(boxOf(graphs.scene, set)) - middleOf(boxOf(graphs.scene, state.parts()));
  const std::vector<Vec3>& directions = graphs.blocking.directions();
  std::vector<int> order;
  for (std::size_t d = 0; d < directions.size(); ++d) {
    order.push_back(static_cast<int>(d));
  }
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return worthOf(directions[static_cast<std::size_t>(a)], outwards) >
           worthOf(directions[static_cast<std::size_t>(b)], outwards);
  });
  return order;
}

bool isIn(const std::vector<int>& set, int part) {
  return std::binary_search(set.begin(), set.end(), part);
}

//! Whether a set can go a finite distance from its place.
bool canGo(const DisassemblyGraphs& graphs,
           const DisassemblyState& state,
           const std::vector<int>& set,
           int direction,
           double distance) {
  const Path path{
      graphs.blocking.directions()[static_cast<std::size_t>(direction)], distance, Vec3{}};
  return std::all_of(set.begin(), set.end(), [&](int part) {
    const std::vector<int>& blockers = graphs.blocking.blockers(direction, part);
    return std::all_of(blockers.begin(), blockers.end(), [&](int other) {
      return !state.has(other) || isIn(set, other) || !graphs.sweep.blocks(part, other, path);
    });
  });
}

//! Whether a set can leave from a place beside its own.
bool canLeave(const DisassemblyGraphs& graphs,
              const DisassemblyState& state,
              const std::vector<int>& set,
              Vec3 start,
              Vec3 direction) {
  const Box all = boxOf(graphs.scene, state.parts());
  const double distance = lattice::length(all.max - all.min) + lattice::length(start) + 1.0;
  const Path path{direction, distance, start};
  for (const int part : set) {
    const Box& box = graphs.scene.parts[static_cast<std::size_t>(part)].box;
    Box way = moved(box, start);
    way.add(moved(box, start + distance * direction));
    for (const int other : state.parts()) {
      if (meet(way, graphs.scene.parts[static_cast<std::size_t>(other)].box, kGap) &&
          !isIn(set, other) && graphs.sweep.blocks(part, other, path)) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

DisassemblyGraphs::DisassemblyGraphs(const Scene& all)
    : scene(all), sweep(all), blocking(all, sweep), neighbours(findNeighbours(all)) {}

std::optional<int> findWayOut(const DisassemblyGraphs& graphs,
                              const DisassemblyState& state,
                              const std::vector<int>& set) {
  for (const int direction : rankedDirections(graphs, state, set)) {
    if (state.isFree(direction, set)) {
      return direction;
    }
  }
  return std::nullopt;
}

Vec3 clearingLeg(const DisassemblyGraphs& graphs,
                 const DisassemblyState& state,
                 const std::vector<int>& set,
                 int direction) {
  constexpr double kLeast = 2.0;
  const Vec3 along = graphs.blocking.directions()[static_cast<std::size_t>(direction)];
  double distance = kLeast;
  for (const int part : set) {
    const Sweep::Extent own = graphs.sweep.extent(part, along);
    for (const int other : graphs.neighbours[static_cast<std::size_t>(part)]) {
      if (state.has(other) && !isIn(set, other)) {
        const double overlap = graphs.sweep.extent(other, along).max - own.min;
        // Only what is beside the way: a beam along the way does not have to be passed as a whole.
        const double most = own.max - own.min + 1.0;
        distance = std::max(distance, std::ceil(std::min(overlap, most) - kGap) + 1.0);
      }
    }
  }
  return distance * along;
}

std::vector<Vec3> findRetraction(const DisassemblyGraphs& graphs,
                                 const DisassemblyState& state,
                                 const std::vector<int>& set) {
  const std::vector<Vec3>& directions = graphs.blocking.directions();
  const std::vector<int> ranked = rankedDirections(graphs, state, set);
  for (const int first : ranked) {
    const Vec3 along = directions[static_cast<std::size_t>(first)];
    for (int length = 1; length <= kMaxRetraction; ++length) {
      if (!canGo(graphs, state, set, first, length)) {
        break;
      }
      const Vec3 start = static_cast<double>(length) * along;
      for (const int second : ranked) {
        const Vec3 away = directions[static_cast<std::size_t>(second)];
        if ((second | 1) != (first | 1) && canLeave(graphs, state, set, start, away)) {
          const Vec3 leg = clearingLeg(graphs, state, set, second);
          return {start, leg};
        }
      }
    }
  }
  return {};
}

}  // namespace liftarm::analysis
