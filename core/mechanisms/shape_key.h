#pragma once

#include <cstdint>
#include <vector>

#include "mechanisms/mechanism.h"

namespace liftarm::mechanisms {

//! \brief A number for each cell of a mechanism, sorted: where it is in the box around all, and
//! what it does. Equal for mechanisms that are the same up to a shift.
using ShapeKey = std::vector<std::uint32_t>;

//! \brief The least key of all rotations: equal for mechanisms that are the same up to a motion.
ShapeKey canonicalKey(const Mechanism& mechanism);

//! \brief The ways that a mechanism can be turned, without those that look alike.
std::vector<Mechanism> turnedWays(const Mechanism& mechanism);

}  // namespace liftarm::mechanisms
