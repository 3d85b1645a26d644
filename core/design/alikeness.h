#pragma once

#include <vector>

#include "layout/layout.h"
#include "search/layout_search.h"
#include "sketch/sketch.h"

namespace liftarm::design {

//! \brief Symmetries of the whole drawing that a model keeps without being asked to (DESIGN 5b.5):
//! mirrors across X and Y, what a builder sees as left and right, front and back; where there are
//! none, any other mirror. Where there is none, or lines cross in each of them, turns by 180
//! degrees as well: with mirrors they are kept one at a time only. \pre sketch was accepted by
//! readSketch.
std::vector<sketch::Symmetry> wishedSymmetries(const sketch::Sketch& sketch);

//! \brief The share of a layout's beams whose image under a symmetry is there, 0 to 1: the largest
//! over the symmetries; 1 where there are none. \details What no parts can do counts as there: a
//! beam that crosses a mirror with its holes half a module off it may stick out on one side, and
//! beams that meet their image may pass it on the next layer (docs/well-built.md, where the
//! finished model is judged by other code). \pre No symmetry is a translation.
double alikeness(const layout::LayoutProblem& problem,
                 const search::LayoutSnapshot& layout,
                 const std::vector<sketch::Symmetry>& symmetries);

}  // namespace liftarm::design
