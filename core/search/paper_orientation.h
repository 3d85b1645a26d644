#pragma once

#include <vector>

#include "base/rng.h"
#include "guide/orientation.h"

namespace liftarm::search {

//! \brief Result of the paper's stage one: a hole axis for each run and for the node of each
//! junction.
struct PaperOrientation {
  guide::Orientation runs;
  std::vector<lattice::Axis> junctions;
};

//! \brief Unit edges between a junction's node, with this hole axis, and next nodes whose axis
//! differs: "adjacent node pairs with different hole orientations" of
//! \cite xu_2019_computational (5.1).
int axisDifferences(const guide::GuidingGraph& graph,
                    const guide::Orientation& runs,
                    const guide::Junction& junction,
                    lattice::Axis axis);

//! \brief The axis of a junction's node with the fewest differences, the first of equals; at a
//! joint the joint's axis (constraint iii).
lattice::Axis junctionAxis(const guide::GuidingGraph& graph,
                           const guide::Orientation& runs,
                           const guide::Junction& junction);

//! \brief Stage one as the paper has it (5.1): one annealing from 2000 down to 0.01, cooled by
//! 1 - 10 / |V| each step; a step turns all interior nodes of one line and its junctions follow.
//!
//! Readings where the paper is silent. A line is one of our runs: collinear lines that meet are
//! one. Lines that the sketch calls symmetric turn together, mirrored (constraint iv); where that
//! is impossible for one of them, the step is refused. The rate is at least 0.5, which it falls
//! below for 20 nodes or fewer. The best state met is returned, not the last. Short lines get no
//! exception (the paper's footnote on lines with one interior hole).
PaperOrientation paperStageOne(const guide::GuidingGraph& graph, base::Rng* rng);

}  // namespace liftarm::search
