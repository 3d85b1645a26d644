#pragma once

#include <string>
#include <string_view>

#include "layout/components.h"
#include "model/model.h"
#include "search/layout_search.h"

namespace liftarm::design {

//! \brief Turns a layout into real parts in their places: the beams, the pins of joints in line,
//! and the mechanisms of the junctions. \details At an annotated joint the pin through the turning
//! groups is one without friction (DESIGN 6). \param sketchJson Kept in the model, so that it can
//! be checked alone.
model::Model buildModel(const layout::LayoutProblem& problem,
                        const mechanisms::MechanismTable& table,
                        const search::LayoutSnapshot& layout,
                        const std::string& name,
                        const std::string& sketchJson);

//! \brief The part that a straight beam with so many pin holes is made of: of 4 and 6 holes, two of
//! them. \pre the search uses the length.
const parts::Part& straightBeamPart(int holes);

}  // namespace liftarm::design
