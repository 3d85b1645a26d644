#pragma once

#include <optional>

#include "parts/catalogue.h"

namespace liftarm::importers {

//! \brief A plane of a part's own frame, across an axis (0 to 2), at a coordinate on it.
struct MirrorPlane {
  int axis = 0;
  double at = 0.0;
};

//! \brief A plane that takes a part to itself: its holes, its heads and its box to their images.
//! Such a part may be placed as a mirror image, which is one of its own poses.
std::optional<MirrorPlane> mirrorPlane(const parts::Part& part);

}  // namespace liftarm::importers
