#pragma once

#include <string>
#include <string_view>

namespace liftarm::importers {

//! \brief The text of a file as UTF-8, without a mark of its encoding: from UTF-8, from UTF-16 with
//! or without its mark, and where bytes are neither, from Windows' Latin letters.
std::string decodedText(std::string_view bytes);

}  // namespace liftarm::importers
