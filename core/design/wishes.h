#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sketch/sketch.h"

namespace liftarm::design {

//! \brief What a search wishes for that the sketch does not ask: tried first, given up where no
//! whole layout was found with it.
struct Wishes {
  bool standing = false;   //!< nothing below the lowest drawn plane (DESIGN 5b.2)
  bool symmetric = false;  //!< the drawing's own symmetries are kept (design/alikeness.h)
  int only = -1;           //!< the one of these that is kept; negative: all
  bool mostly = false;     //!< what stays loose as it is need not be symmetric
  std::uint32_t more = 0;  //!< not 0: of the searches beyond the plans: another seed
  bool few = false;        //!< searched with beams at their price and layers nearly for nothing
  bool settled = false;    //!< goes on from the best layout of all with prices as they are
  bool again = false;      //!< of these: the one that found a layout when it looked at all lines
};

//! \brief The sketch with what is wished for written into it: its ground half a module below its
//! lowest end point, and the mirrors that it has. What it says itself stays.
sketch::Sketch withWishes(const sketch::Sketch& sketch, Wishes wishes);

//! \brief What is tried, the first last: all wishes, then one symmetry after the other, then all
//! but for what is loose, then to stand alone, then nothing.
std::vector<Wishes> plansFor(Wishes all, std::size_t mirrors);

//! \brief Whether all is drawn on one level: it lies on the table whatever its layers are, so that
//! nothing is to be kept up.
bool liesFlat(const sketch::Sketch& sketch);

}  // namespace liftarm::design
