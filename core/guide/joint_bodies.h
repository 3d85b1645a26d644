#pragma once

#include <vector>

namespace liftarm::guide {

//! \brief The bodies on one pin where several joints are drawn about one line.
//! \details A body stays one unless the further joint parts its runs; runs that only the further
//! joint names are bodies of their own, by its groups.
//! \param bodies Runs of each body so far. \param groups Those of the further joint.
void partBodies(std::vector<std::vector<int>>& bodies, const std::vector<std::vector<int>>& groups);

}  // namespace liftarm::guide
