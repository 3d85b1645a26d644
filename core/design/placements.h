#pragma once

#include <string>
#include <string_view>

#include "base/status.h"

namespace liftarm::design {

//! Modules of all lines of a sketch whose placements are listed: a list of more would fill the
//! memory, and no programme proves anything of it.
inline constexpr int kMostPlacedModules = 10000;

//! \brief Every part in every place that the search could lay for a sketch, without layers: what a
//! programme needs that proves how few beams there can be (docs/lower-bound.md).
//! \param settingsJson As for DesignSession::create; what may be laid depends on `set`.
//! \return {"format": "liftarm-placements", "version": 1, "name", "runs": [{"from", "to":
//! [x,y,z]}], "edges": [{"run", "index"}]: unit edges that some part must cover, "covers":
//! [{"kind": "straight" | "bent" | "frame" | "axle", "part": LDraw number, "parts": real ones that
//! it is made of, "runs", "edges": indices of those above}], "rivals": [[indices of covers of which
//! one at most can be there]], "limits":
//! [{"part", "owned"}]: `owned` parts at most, "quickBound": that of search/cover_bound.h};
//! or the one message that says what is wrong with either text.
base::Result<std::string> placementsJson(std::string_view sketchJson,
                                         std::string_view settingsJson);

}  // namespace liftarm::design
