#pragma once

#include "layout/local_view.h"

namespace liftarm::layout {

//! LDraw number of the beam of one hole, which fills a gap in a stack and covers no edge.
inline constexpr const char* kSpacerPart = "18654";

//! What a spacer costs, in connecting parts: itself, and no head that holds.
inline constexpr double kSpacerCost = 1.15;

//! \brief What is wrong with a stack of beams on one hole axis (DESIGN 7).
struct StackFaults {
  int gaps = 0;      //!< empty layers between the lowest and the highest
  int overfull = 0;  //!< beams beyond what one pin or axle holds
  int fillable = 0;  //!< gaps that spacers can fill, so that one pin or axle holds all: `gaps` or 0
};

//! \param layers Bit l + kMaxLayer is set when a beam lies on layer l.
StackFaults stackFaults(unsigned layers);

}  // namespace liftarm::layout
