#pragma once

#include "analysis/findings.h"
#include "analysis/scene.h"

namespace liftarm::analysis {

//! Solids may enter each other by this much, modules: faces that touch, and rounded numbers.
inline constexpr double kPenetration = 0.03;

//! How far the middle line of a part may lie below the ground, modules.
inline constexpr double kGroundTolerance = 0.05;

//! \brief Item 2 of DESIGN 5: no two parts interpenetrate, none enters a keep-out box or lies below
//! the ground. \details Bodies, heads and collars of different parts are tested pair by pair. A
//! head in a hole of the other part is let off (whether it fits is item 3), and so is a collar that
//! lies in the rim of a pin hole. A beam on a line at ground level reaches half a module below it:
//! what counts is its middle line.
ItemResult checkInterpenetration(const Scene& scene);

}  // namespace liftarm::analysis
