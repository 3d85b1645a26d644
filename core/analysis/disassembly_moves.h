#pragma once

#include <optional>
#include <vector>

#include "analysis/blocking.h"
#include "analysis/disassembly_state.h"
#include "analysis/scene.h"
#include "analysis/sweep.h"

namespace liftarm::analysis {

//! \brief A model with the graphs that its disassembly is planned on. Keeps a reference to the
//! scene.
struct DisassemblyGraphs {
  explicit DisassemblyGraphs(const Scene& scene);

  const Scene& scene;
  Sweep sweep;
  BlockingGraph blocking;
  std::vector<std::vector<int>> neighbours;
};

//! \brief The best of the directions in which a set can leave as a whole: up, then outwards, down
//! last. \return Nothing where it is blocked in all of them. \param set Ascending.
std::optional<int> findWayOut(const DisassemblyGraphs& graphs,
                              const DisassemblyState& state,
                              const std::vector<int>& set);

//! \brief How far a set must go until its parts are clear of those that they are connected to.
//! \return A move of whole modules, at least two.
lattice::Vec3 clearingLeg(const DisassemblyGraphs& graphs,
                          const DisassemblyState& state,
                          const std::vector<int>& set,
                          int direction);

//! \brief Draws a set out by a few modules and then away in another direction.
//! \return Two legs, or nothing.
std::vector<lattice::Vec3> findRetraction(const DisassemblyGraphs& graphs,
                                          const DisassemblyState& state,
                                          const std::vector<int>& set);

}  // namespace liftarm::analysis
