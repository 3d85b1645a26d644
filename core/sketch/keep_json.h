#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "sketch/json_fields.h"
#include "sketch/keep.h"
#include "sketch/sketch.h"

namespace liftarm::sketch {

//! \brief Reads the member `keep` of a document: for each line the parts that are to stay on it,
//! those that may not lie there, its layers, and where its beams end (docs/keep.md).
//! \return False when `fields` has noted what is wrong. \pre sketch.lines is read.
bool readKeeps(const nlohmann::json& document,
               FieldReader& fields,
               const Sketch& sketch,
               Keeps& keeps);

//! \brief What a sketch's text keeps. \param sketch As readSketch gave it for the same text.
Keeps keepsOf(std::string_view text, const Sketch& sketch);

//! \brief `,\n  "keep": [` with one element a line; nothing where nothing is kept.
std::string keepsText(const Keeps& keeps);

//! \brief An LDraw part number: 1 to kMaxPartNumber digits, small letters, hyphens and dots.
bool readPartNumber(const nlohmann::json& value,
                    FieldReader& fields,
                    const std::string& place,
                    std::string& part);

//! \brief One of its `parts`.
std::string keptPartText(const KeptPart& part);

}  // namespace liftarm::sketch
