#pragma once

#include <vector>

#include "layout/beam.h"

namespace liftarm::layout {

//! \brief Component of each run: runs that meet, lie in one plane and have one hole axis
//! (paper 5.1).
struct Components {
  std::vector<int> ofRun;
  int count = 0;
};

//! \param covers One cover for each run of the graph.
Components findComponents(const guide::GuidingGraph& graph, const std::vector<Cover>& covers);

//! \brief Largest difference of layers within one component (paper 4.3, F_cpt).
int largestLayerRange(const Components& components, const std::vector<Cover>& covers);

}  // namespace liftarm::layout
