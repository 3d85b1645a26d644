#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"
#include "design/settings.h"
#include "model/model.h"

namespace liftarm::design {

inline constexpr std::string_view kOwnedPrefix = "owned.";

//! \brief Notes how many of a part are owned. \param count Any number that a person gave.
//! \return True, or one message that names the key and what would be right.
base::Result<bool> applyOwned(Settings* settings, const std::string& partId, double count);

//! \brief Makes the search obey the owned parts: what is not there at all is not used, of all else
//! too many counts as a violation. \return True, or the message that no model is possible so.
base::Result<bool> limitSearch(Settings* settings);

//! \brief A part of which a model needs more than there are.
struct MissingPart {
  std::string part;  //!< LDraw number
  int needed = 0;
  int owned = 0;

  //! \brief One sentence for a person.
  [[nodiscard]] std::string message() const;
};

//! \brief What a finished model needs beyond the owned parts, counted from its parts alone.
std::vector<MissingPart> missingParts(const model::Model& model, const Settings& settings);

}  // namespace liftarm::design
