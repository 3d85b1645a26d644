#pragma once

#include <vector>

#include "analysis/disassembly.h"
#include "analysis/disassembly_moves.h"

namespace liftarm::analysis {

//! \brief What is put in as one: a part, or a subassembly.
struct AssemblyUnit {
  Removal removal;
  bool fastener = false;               //!< a single pin, axle or bush
  double floor = 1e9;                  //!< its lowest z, modules
  lattice::Vec3 middle;                //!< of its box
  std::vector<int> touches;            //!< units that it is connected to, ascending
  std::vector<std::vector<int>> hits;  //!< by direction, units in its way out, ascending
};

//! \brief The removals of a group as units, in the order of building.
std::vector<AssemblyUnit> assemblyUnits(const DisassemblyGraphs& graphs,
                                        const std::vector<Removal>& removals);

}  // namespace liftarm::analysis
