#pragma once

#include <string>
#include <string_view>

#include "base/status.h"

namespace liftarm::design {

//! \brief Stage one before and after (paper 5.1, its figure of three examples), for experiments.
//! \param settingsJson As for DesignSession::create(); the seed and `starts` count.
//! \return {"name", "nodes", "runs", "random": {"differences": mean of 100 random orientations,
//! "least", "most"}, "paper": {"differences", "components"}, "default": {the same}}: adjacent nodes
//! with different hole axes under one measure for all (search/paper_orientation.h), and coplanar
//! components; or the one message that says what is wrong with either text.
base::Result<std::string> stageOneJson(std::string_view sketchJson, std::string_view settingsJson);

}  // namespace liftarm::design
