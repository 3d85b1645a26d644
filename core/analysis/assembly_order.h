#pragma once

#include "analysis/disassembly.h"
#include "analysis/disassembly_moves.h"

namespace liftarm::analysis {

//! \brief Puts the removals of a group into another order, so that the reversed order begins with
//! what stands on the table and goes up from there, each part next to what is there already.
//! \details Each part or subassembly keeps its way out, so what must come before what is an acyclic
//! graph; of the orders that it allows a greedy one is taken: the lowest thing that touches what is
//! built, after the pins that hold it there. Several beginnings are tried. Drawn out on two legs or
//! forced, a part keeps what is before and after it. The old order stays where no other one goes
//! downwards less often.
void buildUpwards(const DisassemblyGraphs& graphs,
                  const DisassemblyWishes& wishes,
                  DisassemblyGroup& group);

}  // namespace liftarm::analysis
