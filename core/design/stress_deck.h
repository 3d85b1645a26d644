#pragma once

#include <string>

#include "base/status.h"
#include "model/model.h"

namespace liftarm::design {

//! \brief A model's frame under its weight as an input of another finite element program.
//! \details Pins with friction hold; where the model folds then, all fits are locked, and the title
//! says so. \param format "inp" (CalculiX) or "apdl" (ANSYS). \return The text; kSingular with the
//! reason where the model moves all the same.
base::Result<std::string> writeStressDeck(const model::Model& model, const std::string& format);

}  // namespace liftarm::design
