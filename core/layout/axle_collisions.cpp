#include "layout/axle_collisions.h"

#include <cmath>

#include "base/index.h"

namespace liftarm::layout {

namespace {

using base::at;
using lattice::Vec3;

constexpr double kOnLine = 1e-3;

//! Whether the axle of a run goes through a hole of a beam.
bool passes(const guide::GuidingGraph& graph,
            int run,
            const Axle& axle,
            int other,
            const Cover& otherCover,
            const Beam& beam) {
  const guide::GuideRun& mine = graph.runs[at(run)];
  const guide::GuideRun& theirs = graph.runs[at(other)];
  if (otherCover.axis != alongAxisOf(mine).axis || mine.piece != theirs.piece) {
    return false;
  }
  const Vec3 first = graph.nodes[at(mine.nodes.front())];
  for (int i = beam.start; i <= beam.last(); ++i) {
    const Vec3 offset = holePosition(graph, theirs, otherCover.axis, i, beam.layer) - first;
    const double along = lattice::dot(offset, mine.direction);
    if (beam.hasHoleAt(i) && lattice::length(offset - along * mine.direction) < kOnLine) {
      const auto index = static_cast<int>(std::lround(along));
      return std::abs(along - index) < kOnLine && index >= axle.start && index <= axle.last() &&
             !axle.hasBush(index);
    }
  }
  return false;
}

int hits(const guide::GuidingGraph& graph,
         int run,
         const Cover& cover,
         int other,
         const Cover& otherCover) {
  if (!cover.axle.used()) {
    return 0;
  }
  const Stadium room = roomOf(graph, graph.runs[at(run)], cover.axis, cover.axle);
  int count = 0;
  for (const Beam& beam : otherCover.beams) {
    const Stadium theirs = stadiumOf(graph, graph.runs[at(other)], otherCover.axis, beam);
    count +=
        overlap(room, theirs) && !passes(graph, run, cover.axle, other, otherCover, beam) ? 1 : 0;
  }
  return count;
}

}  // namespace

AlongAxis alongAxisOf(const guide::GuideRun& run) {
  for (int i = 0; i < 3; ++i) {
    if (std::abs(run.direction[i]) > 0.9) {
      return {lattice::axisFromIndex(i), run.direction[i] > 0.0 ? 1 : -1};
    }
  }
  return {};
}

bool goesThrough(const guide::GuidingGraph& graph, int axleRun, int run, lattice::Axis axis) {
  return alongAxisOf(graph.runs[at(axleRun)]).axis == axis && cornerIndex(graph, axleRun, run) >= 0;
}

int axleCollisions(const guide::GuidingGraph& graph,
                   int run,
                   const Cover& cover,
                   int other,
                   const Cover& otherCover) {
  int count =
      hits(graph, run, cover, other, otherCover) + hits(graph, other, otherCover, run, cover);
  if (cover.axle.used() && otherCover.axle.used()) {
    count += overlap(roomOf(graph, graph.runs[at(run)], cover.axis, cover.axle),
                     roomOf(graph, graph.runs[at(other)], otherCover.axis, otherCover.axle))
                 ? 1
                 : 0;
  }
  return count;
}

}  // namespace liftarm::layout
