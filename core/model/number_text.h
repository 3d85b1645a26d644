#pragma once

#include <string>

namespace liftarm::model {

//! \brief A number as a file holds it: rounded to `decimals` digits, no trailing zeros, never -0,
//! the same bytes on every platform. \pre |value| * 10^decimals < 2^63 and finite.
std::string numberText(double value, int decimals = 6);

}  // namespace liftarm::model
