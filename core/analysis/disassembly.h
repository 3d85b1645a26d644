#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "analysis/findings.h"
#include "analysis/scene.h"

namespace liftarm::analysis {

//! Models with more parts are not taken apart: the time grows with the square of their number.
inline constexpr std::size_t kMaxPartsTakenApart = 5000;

//! \brief One part or subassembly that leaves.
struct Removal {
  std::vector<int> parts;  //!< ascending
  //! Straight moves in order, modules. From the end of the last one the way is free for ever in
  //! its direction. Empty: what is left in the end.
  std::vector<lattice::Vec3> legs;
  int group = -1;       //!< several parts: the group that takes them apart
  bool forced = false;  //!< something is in the way: see DisassemblyPlan::stuck
};

//! \brief A connected set of parts and how it comes apart: each removal leaves the rest behind.
struct DisassemblyGroup {
  std::vector<int> parts;         //!< ascending
  std::vector<Removal> removals;  //!< all parts, each once
};

//! \brief Parts that cannot leave, and what is in their way.
struct StuckParts {
  std::vector<int> parts;
  std::vector<int> by;
  std::string message;
};

//! \brief How a model comes apart. Group 0 is the whole; a group's number is above that of the one
//! it leaves.
struct DisassemblyPlan {
  std::vector<DisassemblyGroup> groups;
  std::vector<StuckParts> stuck;
};

//! \brief What a planner should prefer.
struct DisassemblyWishes {
  //! Disjoint connected sets of parts that leave together where they can, before they come apart.
  std::vector<std::vector<int>> units;
  //! Whether parts stand by themselves: of the parts that could leave the whole next, one that lets
  //! the rest stand is taken. May be empty.
  std::function<bool(const std::vector<int>&)> stands;
  //! Parts that nothing else holds leave together with what held them.
  bool holdTogether = false;
  //! Whether the whole, put together, begins with what is lowest: see assembly_order.h.
  bool upwards = false;
  //! Whether parts stand or lie on one of their sides: orders are compared by it. May be empty.
  std::function<bool(const std::vector<int>&)> rests = nullptr;
};

//! \brief Takes a model apart by straight moves of single parts and connected subassemblies.
//! \details On blocking graphs \cite wilson_1994_geometric: a part that nothing blocks in some
//! direction leaves; else a strongly connected set with no way out of it leaves as a whole and is
//! taken apart on its own; else a part is drawn out first and leaves sideways then. Higher parts
//! leave first, pins before what they hold, and what is left stays connected where it can. Where
//! nothing can leave, the part with the fewest others in its way is told as stuck and forced out,
//! so that all that is stuck is found. Polynomial. Parts that the catalogue does not have are
//! passed over.
DisassemblyPlan planDisassembly(const Scene& scene, const DisassemblyWishes& wishes = {});

//! \brief Item 6 of DESIGN 5: the model can be taken apart, so it can be put together.
ItemResult checkDisassembly(const Scene& scene);

}  // namespace liftarm::analysis
