#pragma once

#include <string>
#include <string_view>

namespace liftarm::base {

//! \brief A text that cannot steer what shows it: every control character (C0, DEL, C1, as UTF-8 or
//! as bytes of their own), line and paragraph separators and marks that turn the direction of
//! writing become a space. \details Bytes that are no UTF-8 become `?`.
std::string plainText(std::string_view text);

}  // namespace liftarm::base
