#pragma once

#include <string_view>

namespace liftarm::parts {

//! \brief The text of core/parts/catalogue.json, embedded at build time.
std::string_view catalogueJsonText();

}  // namespace liftarm::parts
