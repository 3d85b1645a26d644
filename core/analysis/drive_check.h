#pragma once

#include "analysis/findings.h"
#include "analysis/gear_trains.h"
#include "analysis/scene.h"

namespace liftarm::analysis {

//! \brief The part of item 7 of DESIGN 5 that is about shafts: each drawn shaft is an axle that
//! runs in two holes and cannot slide, each drive couples two with its ratio, nothing is hit over a
//! turn, and no gears bind. \details On the placed parts alone. A model without gears and without
//! shafts has nothing to fail. \return Its detail is empty where the sketch has no drives.
ItemResult checkDrives(const Scene& scene, const GearTrains& trains);

}  // namespace liftarm::analysis
