#pragma once

#include "model/model.h"
#include "sketch/sketch_colours.h"

namespace liftarm::design {

//! \brief Gives the parts of a model their colours, as its sketch says.
//! \details Pins, axles and connectors have the colours that they usually come in. Beams are
//! coloured by length: yellow from 11 holes on, blue for 7 and 9, red for shorter ones, dark grey
//! for bent beams and frames, so that a builder tells them apart; lengths are the same on both
//! sides of a mirror. Or by their component, or as the catalogue has them. \param model With the
//! sketch that it was made for where lines have colours of their own.
void paint(const sketch::SketchColours& colours, model::Model& model);

//! \brief How many parts of a model are in another colour than the catalogue knows them in: whether
//! they are sold in it has to be looked up.
int countUnusualColours(const model::Model& model);

}  // namespace liftarm::design
