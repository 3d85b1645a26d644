#pragma once

#include "parts/catalogue.h"

namespace liftarm::parts {

//! What sits at the ends of shafts, by LDraw number: an arm with a hole for a handle, that handle,
//! and a wheel.
inline constexpr const char* kCrankArm = "60483";
inline constexpr const char* kCrankHandle = "2780";
inline constexpr const char* kWheel = "3736";

//! \brief How many teeth a gear has: its LDraw title counts them ("Technic Gear 24 Tooth ...").
//! \return 0 for every other part.
int teethOf(const Part& part);

}  // namespace liftarm::parts
