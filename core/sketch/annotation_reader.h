#pragma once

#include <nlohmann/json.hpp>

#include "sketch/json_fields.h"
#include "sketch/sketch.h"

namespace liftarm::sketch {

//! \brief Reads joints, symmetries, keep-out boxes and ground of a document into a sketch.
//! \return False when `fields` has noted what is wrong.
//! \pre document is an object and sketch.lines is read.
bool readAnnotations(const nlohmann::json& document, FieldReader& fields, Sketch& sketch);

}  // namespace liftarm::sketch
