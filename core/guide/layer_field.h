#pragma once

#include <vector>

#include "base/rng.h"
#include "guide/guiding_graph.h"
#include "guide/orientation.h"

namespace liftarm::guide {

//! Marks a junction of a run where the field has no opinion.
inline constexpr int kNoLayer = -100;

//! \brief The layer, 0 or 1, that a run's beam had better have at each of its junctions, in the
//! order of GuideRun::junctions; kNoLayer where nothing is known.
using LayerField = std::vector<std::vector<int>>;

//! \brief Where lines longer than the longest beam should change layers, for all lines of a plane
//! together.
//! \details Beams that follow each other on a line lie on two layers in turn, and beams that cross
//! lie on different layers. With two layers only, going round a mesh of a coplanar component, the
//! number of changes is even: changes lie on walls that cross the whole component. The field takes
//! straight walls, square to the lines, and places them by dynamic programming along each of the
//! plane's two directions, so that all lines together need the fewest beams: what changes layer
//! where is settled for hundreds of lines at once, which moves of single lines find only slowly. It
//! is a proposal for the first layout, not a rule. \param rng Chooses among equally good walls.
LayerField makeLayerField(const GuidingGraph& graph,
                          const Orientation& orientation,
                          base::Rng* rng);

}  // namespace liftarm::guide
