#pragma once

#include "analysis/disassembly.h"
#include "analysis/disassembly_moves.h"

namespace liftarm::analysis {

//! \brief Puts the removals of a group into another order, so that the reversed order begins with
//! what stands on the table and goes up from there, each part next to what is there already.
//! \details Greedily from several beginnings: the lowest thing that touches what is built, with the
//! pins that hold it there, if all that is still missing can come in after it by one straight move.
//! The old order stays where no other one leaves fewer things hanging, goes downwards less often,
//! or rests better. Where a part is forced out nothing is changed.
void buildUpwards(const DisassemblyGraphs& graphs,
                  const DisassemblyWishes& wishes,
                  DisassemblyGroup& group);

}  // namespace liftarm::analysis
