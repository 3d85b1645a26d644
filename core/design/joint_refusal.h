#pragma once

#include <optional>
#include <string>

#include "guide/guiding_graph.h"
#include "sketch/sketch.h"

namespace liftarm::design {

//! \brief Joints that no layout can have, told before a search for one.
//! \details Four kinds. A joint whose axis is along none of x, y and z: no hole is. Joints about
//! two axes at one place: no part has holes for both there. Two bodies whose lines lie on each
//! other. And a line that turns about itself alone: beams have their holes across their line, so it
//! must be an axle, which is as long as axles are and goes through all that it meets. \param
//! longest Slots of the longest axle that may cover a line; 0: the last kind is not looked for.
//! \return One sentence that names the joint, the lines and the reason.
std::optional<std::string> findJointRefusal(const sketch::Sketch& sketch,
                                            const guide::GuidingGraph& graph,
                                            int longest);

}  // namespace liftarm::design
