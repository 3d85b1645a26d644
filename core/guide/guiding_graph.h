#pragma once

#include <optional>
#include <vector>

#include "lattice/vec.h"
#include "sketch/arrangement.h"
#include "sketch/sketch.h"

namespace liftarm::guide {

//! \brief Farthest layer from its line that a beam may have.
inline constexpr int kMaxLayer = 2;

inline constexpr unsigned kAllLayers = (1U << (2U * kMaxLayer + 1U)) - 1U;

//! \brief A run with what the search asks of it: which hole axes it may have, where it may not be
//! passed.
struct GuideRun {
  lattice::Vec3 direction;
  std::vector<int> nodes;           //!< node ids; nodes.size() - 1 unit edges
  std::vector<lattice::Axis> axes;  //!< hole axes that a beam on it may have, at least one
  bool exact = false;               //!< every beam must lie on the line (layer 0)
  unsigned layers = kAllLayers;     //!< those that beams may have: bit (layer + kMaxLayer)
  bool principal = false;           //!< parallel to a principal axis
  double holeShift = 0.0;           //!< of its beams' holes from its nodes, along the direction
  int piece = 0;
  std::vector<int> junctions;        //!< junction ids, in order along the run
  std::vector<int> junctionIndices;  //!< their indices among `nodes`
  std::vector<int> near;             //!< other runs that a beam of this one could touch

  [[nodiscard]] int edgeCount() const { return static_cast<int>(nodes.size()) - 1; }

  [[nodiscard]] bool allows(int layer) const {
    return (layers >> static_cast<unsigned>(layer + kMaxLayer) & 1U) != 0U;
  }
};

//! \brief Where a run meets a junction.
struct Incidence {
  int run = -1;
  int index = 0;  //!< of the node in the run
};

//! \brief A node where runs meet or cross, or where a joint splits a run.
struct Junction {
  int node = -1;
  std::vector<Incidence> incident;
  int joint = -1;             //!< index of the joint here, or -1
  bool bridgeable = false;    //!< mechanisms may stand for beams' ends here: see Bridging
  std::vector<int> nearRuns;  //!< runs whose beams could stand near, the incident ones included
  std::vector<int> nearJunctions;  //!< junctions whose mechanisms could touch this one's
};

//! \brief A joint: the groups of runs that must turn against each other about the axis.
struct GuideJoint {
  int node = -1;
  lattice::Axis axis = lattice::Axis::kY;
  std::vector<std::vector<int>> runGroups;
};

//! \brief Two groups of runs that the sketch calls symmetric: p -> linear * p + shift brings the
//! partners onto the runs. A group that is mirrored or turned is its own partner.
struct GuideSymmetry {
  lattice::Mat3 linear;
  lattice::Vec3 shift;
  std::vector<int> runs;
  std::vector<int> partners;
};

//! \brief The guiding graph: nodes one unit apart on all lines, unit edges between them
//! (paper 4.2), held as straight runs, since beams are straight.
struct GuidingGraph {
  std::vector<lattice::Vec3> nodes;
  std::vector<int> degrees;  //!< unit edges at each node
  std::vector<GuideRun> runs;
  std::vector<Junction> junctions;
  std::vector<GuideJoint> joints;
  std::vector<GuideSymmetry> symmetries;
  std::vector<sketch::KeepOut> keepOut;
  std::optional<double> ground;
  int edges = 0;
  int pieces = 0;
  int lines = 0;
};

//! \brief Whether a mechanism may bridge the edges of a run next to a junction instead of a beam:
//! only where no single hole axis serves all runs, and only on principal lines, whose next node is
//! on the junction's lattice, where mechanisms live.
inline bool mayBridge(const GuideRun& run, const Junction& junction) {
  return run.principal && junction.bridgeable;
}

//! \brief Where mechanisms may bridge edges though one hole axis would serve all runs.
enum class Bridging {
  kWhereNeeded,  //!< nowhere
  kAtEnds,       //!< where all runs end: a corner of two beams on their lines, held by a connector
};

//! \brief Builds the guiding graph of a sketch.
//! \details A run is split where its edges have different fixed hole axes or exactness, and at
//! joints whose groups lie on both sides, so that no beam can pass there (paper 5.1).
GuidingGraph buildGuidingGraph(const sketch::Sketch& sketch,
                               Bridging bridging = Bridging::kWhereNeeded);

}  // namespace liftarm::guide
