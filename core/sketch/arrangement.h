#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "lattice/vec.h"
#include "sketch/sketch.h"

namespace liftarm::sketch {

//! \brief A node: a point at unit spacing on one or more runs.
struct ArrangedNode {
  lattice::Vec3 position;
  std::vector<std::pair<int, int>> runs;  //!< (run, index of this node in the run's nodes)
};

//! \brief One unit edge of a run, between nodes[i] and nodes[i + 1].
struct ArrangedEdge {
  std::vector<int> lines;                 //!< source lines that contain it
  bool exact = false;                     //!< from any of its lines
  std::optional<lattice::Axis> holeAxis;  //!< from the first line that fixes it
};

//! \brief A maximal straight chain of collinear lines that overlap or share nodes.
struct Run {
  lattice::Vec3 direction;  //!< unit length
  std::vector<int> nodes;   //!< node ids, one module apart; one more than edges
  std::vector<ArrangedEdge> edges;
  int piece = 0;  //!< connected part of the sketch
};

//! \brief Two runs that cross where no pin can join them: not at a node of both.
struct OffNodeCrossing {
  int runA = -1;
  int runB = -1;
  lattice::Vec3 point;
};

//! \brief A joint of the sketch at its node. `runGroups` are its `between` groups (lines) as runs.
struct ArrangedJoint {
  int node = -1;
  lattice::Vec3 axis;
  std::vector<std::vector<int>>
      lineGroups;  //!< at least two; filled in when the sketch left them out
};

//! \brief The sketch split at shared points: what later stages work on. Order follows the input.
struct Arrangement {
  std::vector<ArrangedNode> nodes;
  std::vector<Run> runs;
  std::vector<ArrangedJoint> joints;
  std::vector<OffNodeCrossing> offNodeCrossings;
  int pieces = 0;
};

//! \brief Points are one when they agree within this many modules.
inline constexpr double kSamePoint = 1e-3;

//! \brief Splits the lines of a sketch at shared points, T contacts and crossings into runs.
//! \pre sketch was accepted by readSketch (whole lengths, limits).
Arrangement arrange(const Sketch& sketch);

}  // namespace liftarm::sketch
