#pragma once

#include <nlohmann/json.hpp>

#include "lattice/vec.h"

namespace liftarm::design {

//! \brief A number as the answers of this folder hold it: rounded to `decimals` digits, never -0;
//! what model::numberText writes, without the text. \details Values too large for that stay as they
//! are. \pre finite.
double rounded(double value, int decimals = 6);

//! \brief [x, y, z], each rounded.
nlohmann::ordered_json pointJson(lattice::Vec3 p, int decimals = 6);

}  // namespace liftarm::design
