#pragma once

#include <vector>

#include "layout/layout.h"

namespace liftarm::objective {

//! \brief Number of rigid subsets of a layout's beams, F_rgd of \cite xu_2019_computational (4.3)
//! before normalisation.
//!
//! Beams and connectors are bodies; a pin is the hinge of all bodies on its line. Two bodies that
//! share two hinges on different lines cannot move against each other and are one from then on,
//! transitively; so are an axle and the axle hole it is in. That two beams are pinned twice, or
//! that one connector holds two holes of each, are the usual cases. Purely local, as in the paper:
//! three beams hinged to a triangle count as three. A beam of two thin halves is one body.
//!
//! \param covers One for each run of the graph.
//!
//! \param junctions One for each junction of the graph.
int countRigidSubsets(const guide::GuidingGraph& graph,
                      const mechanisms::MechanismTable& table,
                      const std::vector<layout::Cover>& covers,
                      const std::vector<layout::JunctionState>& junctions);

}  // namespace liftarm::objective
