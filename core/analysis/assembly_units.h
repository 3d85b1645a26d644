#pragma once

#include <vector>

#include "analysis/disassembly.h"
#include "analysis/disassembly_moves.h"

namespace liftarm::analysis {

//! \brief What is put in as one: a part, or a subassembly.
struct AssemblyUnit {
  Removal removal;
  int direction = -1;       //!< of its way out, among those of the blocking graph
  bool keepsPlace = false;  //!< drawn out on two legs or forced: all others stay before or after it
  bool fastener = false;    //!< a single pin, axle or bush
  double floor = 1e9;       //!< its lowest z, modules
  lattice::Vec3 middle;     //!< of its box
  std::vector<int> before;  //!< units that must be there before it: acyclic
  std::vector<int> touches;  //!< units that it is connected to, ascending
};

//! \brief The removals of a group as units in the order of building, with what their ways out say
//! about other orders.
//! \details A unit must be there before those that it would hit on its way out. What is left in the
//! end of taking apart has no way out of its own; it gets one that few others have to wait for.
std::vector<AssemblyUnit> assemblyUnits(const DisassemblyGraphs& graphs,
                                        const std::vector<Removal>& removals);

}  // namespace liftarm::analysis
