#pragma once

#include <vector>

#include "lattice/vec.h"

namespace liftarm::guide {

//! \brief How far the holes of a run's beams lie from its nodes, along its direction.
//! \details Lengths that do not quite close leave a run a little longer or shorter than its holes
//! are apart. That is shared between both ends, so that a pin at either has the least play to take.
//! \param nodes Of the graph. \param ofRun Those of the run, a module apart.
//! \return Modules; exactly 0 where the lengths close but for rounding.
double holeShiftOf(const std::vector<lattice::Vec3>& nodes, const std::vector<int>& ofRun);

}  // namespace liftarm::guide
