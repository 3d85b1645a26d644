#pragma once

#include <vector>

#include "sketch/sketch.h"

namespace liftarm::sketch {

//! \brief Layers that beams of a line may have, as bits (layer + reach); all of them where nothing
//! that must move forbids any.
using LayerBits = unsigned;

//! \brief Which layers the lines of a sketch may use so that what must turn passes what stands.
//! \details Each joint with a required range is driven through it on the lines alone
//! (moving_bodies.h). Bodies whose beams would meet on the way (stadia of half a module around
//! their lines) may share no layer, and bodies on one pin must lie on neighbouring layers, since a
//! pin holds no beams with nothing between them. Layers that obey all of it and are nearest to the
//! lines are found by depth-first search. A body whose lines meet at an angle has two layers.
//! \param reach The farthest layer from a line.
//! \return By line; empty where no joint has a range, or where no such layers exist: then the
//! search is free, and the check of the model says what stops it.
std::vector<LayerBits> movingLayers(const Sketch& sketch, int reach);

}  // namespace liftarm::sketch
