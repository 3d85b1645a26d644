#pragma once

#include "guide/guiding_graph.h"
#include "layout/beam.h"

namespace liftarm::layout {

//! \brief Which way an axle on a principal run points.
struct AlongAxis {
  lattice::Axis axis = lattice::Axis::kX;
  int sign = 1;
};

AlongAxis alongAxisOf(const guide::GuideRun& run);

//! \brief The room that an axle and its bushes take, as if it were a beam.
inline Stadium roomOf(const guide::GuidingGraph& graph,
                      const guide::GuideRun& run,
                      lattice::Axis axis,
                      const Axle& axle) {
  return {holePosition(graph, run, axis, axle.start, 0),
          holePosition(graph, run, axis, axle.last(), 0),
          axis};
}

//! \brief Whether an axle on one run goes through the beams of another with this hole axis, and is
//! laid anew to suit them.
bool goesThrough(const guide::GuidingGraph& graph, int axleRun, int run, lattice::Axis axis);

//! \brief Pairs that interpenetrate, of the axle of one run with what covers another, and the other
//! way round. \details A beam of the same piece whose hole the axle goes through, where there is no
//! bush, is in nobody's way.
int axleCollisions(const guide::GuidingGraph& graph,
                   int run,
                   const Cover& cover,
                   int other,
                   const Cover& otherCover);

}  // namespace liftarm::layout
