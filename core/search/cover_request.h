#pragma once

#include <span>

#include "guide/guiding_graph.h"
#include "layout/beam.h"
#include "layout/stack.h"

namespace liftarm::search {

//! \brief What a beam, a joint in line and a violation cost while one run is covered anew.
struct CoverCosts {
  double beam = 10.0;                   //!< each real beam part
  double hole = 0.05;                   //!< each hole: prefers beams that fit
  double layer = 0.4;                   //!< each layer off the line, for each beam
  double layerHole = 0.0;               //!< each hole times layer squared (the paper's deviation)
  double hinge = 3.0;                   //!< two beams in line that share one hole only
  double overhang = 2.0;                //!< a beam that sticks out past the run's end
  double spacer = layout::kSpacerCost;  //!< each gap that a spacer fills
  double violation = 25.0;  //!< a collision, gap or overfull stack, times the place's weight
};

//! \brief How freely runs are covered anew.
struct Manner {
  double noise = 0.0;            //!< highest random amount added to each beam's cost
  int reach = guide::kMaxLayer;  //!< highest layer on either side; fewer layers, less work
};

//! \brief All that is asked of one cover. The lists must outlive the asking, no longer.
struct CoverRequest {
  int run = 0;
  lattice::Axis axis = lattice::Axis::kX;  //!< of its holes
  Manner manner = {};
  //! Beams that it must contain as they are: arms of bent beams and bars of frames. They may have
  //! lengths that no other beam may have.
  std::span<const layout::Beam> fixed = {};
  //! Layers that it had better have at the run's junctions (guide/layer_field); empty: any.
  std::span<const int> preferred = {};
  //! What a beam of each allowed length costs besides; empty: nothing.
  std::span<const double> lengthCosts = {};
};

}  // namespace liftarm::search
