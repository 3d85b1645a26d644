#pragma once

#include "analysis/well_built.h"

// The six items of judgeWellBuilt(), one file each.

namespace liftarm::analysis {

//! \brief How far beams lie off their lines, and how far anything sticks out.
WellBuiltItem judgeFaithful(const WellBuiltQuery& query);

//! \brief Whether a drawing with a base gives a model that stands on it: nothing below the base,
//! feet on one level, the centre of mass above them where the drawing's own is.
//! \details The base is the lowest drawn plane. It is flat where a line lies in it; the drawing
//! could stand where its lines, all equally heavy, have their centre well inside the convex hull of
//! what lies in that plane. Feet are the corners of that hull.
WellBuiltItem judgeStanding(const WellBuiltQuery& query);

//! \brief What moves though no joint says so, every pin turning: freedoms of the whole, and beams
//! that hang on one line and turn about it.
WellBuiltItem judgeStiffness(const WellBuiltQuery& query);

//! \brief Heads that sit in nothing, and arms of connectors that hold nothing.
//! \details A head is a module of a pin, one module of a connector's pin or axle, or an end of an
//! axle. An arm is an end module of a connector's body with a head or hole of its own; those
//! without a use are told apart and do not count as heads.
WellBuiltItem judgeCleanness(const WellBuiltQuery& query);

//! \brief How many beams have their image under the drawing's own mirrors; where it has none, under
//! its rotations. The best of them counts.
WellBuiltItem judgeSymmetry(const WellBuiltQuery& query);

//! \brief How many parts and kinds of parts there are, and which are of no use: they join less than
//! two parts, or are beams that stand for no line and hold nothing together.
WellBuiltItem judgeFewness(const WellBuiltQuery& query);

}  // namespace liftarm::analysis
