#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "sketch/json_fields.h"
#include "sketch/shaft.h"

namespace liftarm::sketch {

//! \brief Reads the members `shafts` and `drives` of a document (docs/shafts.md).
//! \return False when `fields` has noted what is wrong.
bool readShafts(const nlohmann::json& document, FieldReader& fields, Shafts& shafts);

//! \brief What turns, by a sketch's text. \pre readSketch accepts it.
Shafts shaftsOf(std::string_view text);

//! \brief `,\n  "shafts": [` and so on, with one element a line; nothing where there is no shaft.
std::string shaftsText(const Shafts& shafts);

}  // namespace liftarm::sketch
