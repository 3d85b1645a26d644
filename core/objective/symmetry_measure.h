#pragma once

#include <vector>

#include "guide/guiding_graph.h"
#include "lattice/vec.h"
#include "layout/beam.h"

namespace liftarm::objective {

//! \brief A map of space onto itself: p -> linear * p + shift. The linear part is orthogonal; a
//! mirror's has determinant -1.
struct SymmetryMap {
  lattice::Mat3 linear;
  lattice::Vec3 shift;  //!< modules

  [[nodiscard]] lattice::Vec3 apply(lattice::Vec3 p) const { return linear * p + shift; }
};

//! \brief The mirror image in the plane {p : normal.p = offset}. \pre normal has unit length.
SymmetryMap reflection(lattice::Vec3 normal, double offset);

SymmetryMap translation(lattice::Vec3 vector);

//! \brief Two groups of runs that should look alike (paper 4.3, (B_i, B_j, T_ji)); equal for
//! self-symmetry.
struct SymmetryGroup {
  SymmetryMap map;            //!< brings the partners onto the runs
  std::vector<int> runs;      //!< B_i, run ids
  std::vector<int> partners;  //!< B_j, run ids
};

//! \brief F_sym of \cite xu_2019_computational (4.3): the mean over groups of the squared Hausdorff
//! distance between the holes of one group and the mapped holes of its partner, over the first
//! group's number of holes.
//!
//! \param covers One for each run of the graph.
//!
//! \return Square modules per hole; 0 without groups. A group of which one side has no beams yet
//! adds 0.
double symmetryDeviation(const guide::GuidingGraph& graph,
                         const std::vector<layout::Cover>& covers,
                         const std::vector<SymmetryGroup>& groups);

//! \brief The runs of which a hole has no counterpart under one of the groups, ascending.
std::vector<int> asymmetricRuns(const guide::GuidingGraph& graph,
                                const std::vector<layout::Cover>& covers,
                                const std::vector<SymmetryGroup>& groups);

}  // namespace liftarm::objective
