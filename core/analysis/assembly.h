#pragma once

#include <vector>

#include "analysis/coverage.h"
#include "analysis/findings.h"
#include "analysis/scene.h"

namespace liftarm::analysis {

//! \brief The assembly of each part: parts that fits join to each other (an axle in a pin hole
//! joins nothing, unless stops hold it). A beam by itself is an assembly: a line may be all of its
//! piece. Other parts that nothing holds are -1: item 3 tells of them.
std::vector<int> findAssemblies(const Scene& scene);

//! \brief How many groups there are, numbered from 0 on; -1 is none.
int groupCount(const std::vector<int>& groups);

//! \brief Item 4 of DESIGN 5: the parts of each connected part of the sketch form one connected
//! assembly, and there is no assembly without a part of the sketch. Assemblies are matched to
//! connected parts, each of whose covered edges the assembly must cover: lines of two of them may
//! lie side by side, so that a beam could stand for either. Without a sketch: one assembly in all.
ItemResult checkAssembly(const Scene& scene, const std::vector<EdgeCover>& coverage);

//! \brief Connected parts of the sketch: lines that share a node. One number per line, from 0.
std::vector<int> piecesOfSketch(const Scene& scene, const std::vector<EdgeCover>& coverage);

}  // namespace liftarm::analysis
