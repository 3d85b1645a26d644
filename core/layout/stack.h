#pragma once

#include "layout/local_view.h"

namespace liftarm::layout {

//! \brief What is wrong with a stack of beams on one hole axis (DESIGN 7).
struct StackFaults {
  int gaps = 0;      //!< empty layers between the lowest and the highest
  int overfull = 0;  //!< beams beyond what one pin holds
};

//! \param layers Bit l + kMaxLayer is set when a beam lies on layer l.
StackFaults stackFaults(unsigned layers);

}  // namespace liftarm::layout
