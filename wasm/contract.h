#pragma once

#include <string>

#include "base/status.h"

namespace liftarm::wasm {

//! \brief The name under which JavaScript knows a status (web/src/solver/solver-module.ts).
std::string statusName(base::Status status);

//! \brief What both sides must agree on, as JSON: {"statuses": [names in the order of the enum],
//! "settings": {every setting with its default}}. tests/contract compares it with the TypeScript.
std::string contractJson();

}  // namespace liftarm::wasm
