#pragma once

#include <string>

#include "base/status.h"
#include "design/settings.h"

namespace liftarm::design {

//! \brief Whether a key of `set` is a list of parts: axles, bent, connectors, frames or lengths.
bool isPartList(const std::string& key);

//! \brief Takes the parts of one kind that the search may use from a list such as "2780,6558".
//! \return True, or one message that names the key and what would be right. \pre isPartList(key).
base::Result<bool> applyPartList(Settings* settings,
                                 const std::string& key,
                                 const std::string& text);

}  // namespace liftarm::design
