#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "guide/guiding_graph.h"
#include "lattice/vec.h"

namespace liftarm::layout {

//! \brief Half the side of the box of unit cells around a junction in which its mechanisms live.
inline constexpr int kBoxRadius = 4;
inline constexpr int kBoxSide = 2 * kBoxRadius + 1;
inline constexpr int kBoxCells = kBoxSide * kBoxSide * kBoxSide;
inline constexpr int kLayerCount = 2 * guide::kMaxLayer + 1;

//! Holes farther than this from a junction join nothing there: three modules, squared.
inline constexpr int kReachSquared = 9;

//! \brief The cell one step along an axis.
inline lattice::Cell unitCell(lattice::Axis axis) {
  lattice::Cell cell;
  cell[lattice::index(axis)] = 1;
  return cell;
}

inline lattice::Cell scaled(int s, lattice::Cell c) {
  return {s * c.x, s * c.y, s * c.z};
}

constexpr bool inBox(lattice::Cell c) {
  return c.x >= -kBoxRadius && c.x <= kBoxRadius && c.y >= -kBoxRadius && c.y <= kBoxRadius &&
         c.z >= -kBoxRadius && c.z <= kBoxRadius;
}

constexpr int boxIndex(lattice::Cell c) {
  return ((c.x + kBoxRadius) * kBoxSide + c.y + kBoxRadius) * kBoxSide + c.z + kBoxRadius;
}

//! \brief A cell that a beam off the junction's lattice blocks while it covers any of [low, high]
//! of its run.
struct Shadow {
  int cell = 0;
  double low = 0.0;
  double high = 0.0;
};

//! \brief How one run lies in the box around a junction.
struct RunView {
  int run = -1;
  int incidentIndex = -1;  //!< node index at the junction if the run passes there, else -1
  bool aligned = false;    //!< its nodes are cells of the box's lattice, one step apart
  lattice::Cell base;      //!< aligned: cell of node 0, layer 0
  lattice::Cell step;      //!< aligned: from node to node
  double low = 0.0;        //!< node indices between which beams can matter here
  double high = -1.0;
  std::vector<std::pair<int, lattice::Cell>>
      onLattice;  //!< not aligned: nodes that are cells, layer 0
  //! Not aligned: blocked cells by place of the hole axis in the run's axes, and layer.
  std::array<std::array<std::vector<Shadow>, kLayerCount>, 2> shadows;
};

//! \brief Another junction whose mechanisms reach into the box.
struct JunctionView {
  int junction = -1;
  bool aligned = false;
  lattice::Cell shift;   //!< aligned: the other junction's cell
  lattice::Vec3 offset;  //!< its place relative to this one
};

//! \brief All that does not change while one junction is solved again and again.
struct LocalView {
  std::vector<RunView> runs;
  std::vector<JunctionView> junctions;
  std::vector<int> forbidden;  //!< box cells below the ground or in a keep-out box
};

//! \brief Half the width of a connector's body in its cell: square, whatever its holes are.
inline constexpr double kConnectorHalfWidth = 0.46;

//! \brief A beam's middle line farther than this from a cell's middle, on some axis, leaves it
//! free.
inline constexpr double kBeamReach = 1.0;

//! \brief Builds the views of all junctions, in the order of graph.junctions.
std::vector<LocalView> buildLocalViews(const guide::GuidingGraph& graph);

//! \brief Whether a part's middle may not be at this point (keep-out boxes and ground, DESIGN 3).
bool forbiddenAt(const guide::GuidingGraph& graph, lattice::Vec3 point);

}  // namespace liftarm::layout
