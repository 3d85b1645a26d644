#pragma once

#include <utility>
#include <vector>

#include "analysis/constraints.h"

namespace liftarm::analysis {

//! \brief A linkage with fewer bodies and the same freedoms.
struct MergedLinkage {
  std::vector<int> bodyOf;  //!< for each body of the source: its body here, by first member from 0
  Linkage linkage;          //!< every link turns; the links on one line form a tree
};

//! \brief Joins what cannot move against each other, as far as short loops tell.
//! \details (1) Links that neither turn nor shift join their bodies. (2) Bodies on one line are
//! hinged to each other whichever of them the pin was drawn with; two bodies on two lines are one
//! body. (3) Bodies round a loop of links whose screws are linearly independent are one body: the
//! loop has no motion at the first order, so it has none at all. Repeated until nothing changes.
MergedLinkage mergeRigid(const Linkage& linkage);

//! \brief The same once more on what was merged before. \param joined Pairs of its bodies that are
//! known to be one.
MergedLinkage mergeFurther(const MergedLinkage& merged,
                           const std::vector<std::pair<int, int>>& joined);

}  // namespace liftarm::analysis
