#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "base/status.h"
#include "lattice/vec.h"

namespace liftarm::sketch {

//! \brief What a JSON text may hold before anything is built from it.
struct JsonLimits {
  std::size_t maxDepth = 12;          //!< arrays and objects inside each other
  std::size_t maxValues = 2'000'000;  //!< numbers, strings, arrays, objects and literals together
  std::string_view countedKey;        //!< this top-level array may hold at most maxCounted elements
  std::size_t maxCounted = 0;
};

//! \brief Parses JSON strictly: no comments, no NaN, no key twice in one object, every number
//! finite. \details Stops at the first breach, so that a hostile text costs neither memory nor
//! stack. \return The document, or kInvalidInput with line and column, or with the place of the
//! value at fault.
base::Result<nlohmann::json> parseJsonText(std::string_view text, const JsonLimits& limits);

//! \brief A number as short as its meaning allows, for messages: at most 4 digits after the point.
std::string shortNumber(double value);

//! \brief A point with three such numbers, for messages: "[1, 2.5, 0]".
std::string pointText(const lattice::Vec3& point);

//! \brief Text of a file in quotes, made safe for one line of a message: no control characters, cut
//! at 40 bytes.
std::string inQuotes(std::string_view text);

}  // namespace liftarm::sketch
