#pragma once

#include <vector>

#include "analysis/coverage.h"
#include "analysis/freedoms.h"
#include "analysis/scene.h"

namespace liftarm::analysis {

//! \brief The joints of the sketch as lines between two parts: on either side the beam that covers
//! the edge of that side nearest to the joint. \details Sides are two groups of
//! `between`, each two of them where there are more: all bodies on one pin must turn against each
//! other. Where it is left out, the first line at the joint's place and the others. Nothing where
//! no beam covers a side.
std::vector<JointLine> findJointLines(const Scene& scene, const std::vector<EdgeCover>& coverage);

//! \brief A model as a question about freedoms; bodies are parts. Frame bodies are beams with more
//! than one hole.
FreedomsQuery makeFreedomsQuery(const Scene& scene,
                                const std::vector<EdgeCover>& coverage,
                                Friction friction);

}  // namespace liftarm::analysis
