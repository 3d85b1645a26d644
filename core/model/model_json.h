#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/status.h"
#include "model/model.h"

namespace liftarm::model {

//! Limits, checked before anything else is done with the input.
inline constexpr std::size_t kMaxModelBytes = 64U << 20U;
inline constexpr std::size_t kMaxParts = 100000;
inline constexpr double kMaxPosition = 5000.0;  //!< modules, in magnitude

//! \brief Reads a model file.
//! \details {"format": "liftarm-model", "version": 1, "name", "parts": [{"part", "color",
//! "position": [x, y, z], "rotation": nine numbers by rows, "component", "layer", "piece"}],
//! "sketch"}. Needed: format, version, parts and in each part `part`, `position` and `rotation`;
//! unknown keys are passed over, so that files of later versions still open. Whether the parts are
//! real and their rotations proper is for analysis/check.h to say. What rounding has moved is put
//! right (seating.h). \return The model, or
//! kInvalidInput with one message that names the place and what would be right.
base::Result<Model> readModel(std::string_view json);

//! \brief Writes a model: one part a line, numbers rounded to 1e-12 (closed chains of hinges must
//! still close after it), the same bytes for the same model.
std::string writeModel(const Model& model);

//! \brief The model as those get it who read its file: what is judged before it is written is
//! judged alike after it.
Model asWritten(const Model& model);

}  // namespace liftarm::model
