#pragma once

#include <optional>
#include <string>
#include <vector>

#include "design/crowded_place.h"
#include "design/settings.h"
#include "layout/layout.h"
#include "model/model.h"
#include "search/layout_search.h"
#include "sketch/sketch.h"
#include "sketch/sketch_notes.h"

namespace liftarm::design {

//! \brief What a report is made from.
struct ReportInput {
  const layout::LayoutProblem& problem;
  const Settings& settings;
  const mechanisms::MechanismTable& table;
  const search::LayoutSearch& search;
  const sketch::Sketch& sketch;
  const std::vector<sketch::Note>& notes;
  const std::optional<CrowdedPlace>& crowded;
  const std::optional<layout::KeepFault>& blamed;
  model::Model model;
};

//! \brief The report of DESIGN 4 without its times, as JSON. Whether the model is buildable, its
//! gaps, collisions and the like are what the checks find on the model, not what the search
//! believes.
std::string makeReport(const ReportInput& input);

}  // namespace liftarm::design
