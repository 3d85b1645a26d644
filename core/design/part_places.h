#pragma once

#include <string>
#include <string_view>

#include "base/status.h"

namespace liftarm::design {

//! \brief Where the parts of a model lie on the lines of its sketch, as the sketch format keeps
//! them (docs/keep.md). \param modelJson With its sketch inside. \param layoutJson What
//! DesignSession::layoutJson() gave for it. \param settingsJson Those of the search.
//! \return {"places": [by part of the model: {"line", "part": one of `keep[].parts`} or null for
//! what lies on no line: pins, connectors, bushes, axles]}. Both halves of a beam made of two thin
//! ones have the same place.
base::Result<std::string> partPlacesJson(std::string_view modelJson,
                                         std::string_view layoutJson,
                                         std::string_view settingsJson);

//! \brief What else could lie where a part of the model does: straight beams that begin or end
//! where it does, bent beams and frames with a stretch in common with it, on its layer; and its own
//! other layers. Whether there is a whole layout with it, a search says. \return {"fits": [as
//! `places`], "layers": [as `places`]}; both empty for parts without a place.
base::Result<std::string> fittingPartsJson(std::string_view modelJson,
                                           std::string_view layoutJson,
                                           std::string_view settingsJson,
                                           int part);

}  // namespace liftarm::design
