#pragma once

#include <vector>

#include "analysis/findings.h"
#include "analysis/scene.h"

namespace liftarm::analysis {

//! Beams further from their line than this many layers do not stand for it.
inline constexpr int kMaxLayer = 3;

//! A mechanism that bridges an uncovered edge lies within this distance of it, modules.
inline constexpr double kBridgeReach = 3.0;

//! \brief A beam that covers a unit edge of the sketch.
struct Cover {
  int part = -1;
  double layer = 0.0;      //!< offset from the line along the hole axis; quarters for thin beams
  lattice::Vec3 holeAxis;  //!< world, unit
  bool said = false;       //!< the model says that the beam is on this layer of its line
  int stretch = 0;         //!< which of the part's stretches
  double place = 0.0;      //!< of the edge's middle, from the beginning of that stretch
};

//! \brief One unit edge of a sketch line and what covers it.
struct EdgeCover {
  int line = -1;
  int edge = 0;  //!< from line.from + edge * direction, one module
  lattice::Vec3 from;
  lattice::Vec3 to;
  std::vector<Cover> covers;
};

//! \brief Every unit edge of the sketch with the beams that cover it, line after line.
//! \details A beam covers an edge where one of its stretches contains it up to an offset of at most
//! kMaxLayer whole modules along the beam's hole axis. On `exact` lines the offset is 0; `holeAxis`
//! of a line rules out other hole axes. Each module of a beam stands for one edge
//! (cover_matching.h). \return Empty where the scene has no sketch.
std::vector<EdgeCover> findCoverage(const Scene& scene);

//! \brief Item 5 of DESIGN 5: every unit edge is covered or bridged.
//! \details Bridged: the beams that go on at both ends of the uncovered edges are joined to each
//! other by connections within kBridgeReach of them, or an axle that cannot slide out lies along
//! the edges and is joined to a beam of the other lines at every node where they meet these.
ItemResult checkCoverage(const Scene& scene, const std::vector<EdgeCover>& coverage);

//! \brief Empty layers in the stacks of beams at the nodes of the sketch (paper 4.3), the sum over
//! nodes of layer range + 1 - number of distinct layers. A spacer in between fills its layer; a
//! beam without a hole there, as frames are between their holes, neither counts nor fills.
int countGaps(const Scene& scene, const std::vector<EdgeCover>& coverage);

}  // namespace liftarm::analysis
