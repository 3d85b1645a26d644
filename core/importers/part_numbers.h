#pragma once

#include <string>
#include <string_view>

#include "parts/catalogue.h"

namespace liftarm::importers {

//! \brief The part that a file means by a number: by the number itself, that of another mould, a
//! print, or another number under which the same part is sold.
//! \param name As a file gives it, in lower case, with or without `.dat` and the folder before it.
//! \return Null where it is not known.
const parts::Part* knownPart(std::string_view name, const parts::Catalogue& catalogue);

//! \brief The name without its folder and its ending.
std::string plainNumber(std::string_view name);

}  // namespace liftarm::importers
