#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lattice/vec.h"

namespace liftarm::sketch {

//! \brief A stretch of a line: nodes of it, counted from its first end point; a part may reach past
//! either end.
struct Stretch {
  int line = 0;
  int from = 0;  //!< at most `to`
  int to = 0;
};

//! \brief A part as it lies on a line. Its round holes along its hole axis, from the first to the
//! last, are at the nodes of the stretch; parts of several bars lie on a stretch for each.
struct KeptPart {
  std::string part;  //!< LDraw number; of beams made of two thin ones, that of both
  Stretch on;
  int layer = 0;  //!< modules off the line along the hole axis
  lattice::Axis holeAxis = lattice::Axis::kX;
  std::vector<Stretch> with;  //!< of its other bars
};

//! \brief A part that may not lie on a stretch, on whichever layer.
struct BarredPart {
  std::string part;
  Stretch on;
};

//! \brief What a person wants of the parts on one line (docs/keep.md). The lines know nothing of
//! it.
struct Keep {
  int line = 0;
  std::vector<KeptPart> parts;
  std::vector<BarredPart> barred;
  std::vector<int> layers;  //!< on which its beams may lie, ascending; empty: any
  //! Nodes past which a beam reaches by one at most, on one side or the other.
  std::vector<int> splits;
};

using Keeps = std::vector<Keep>;

inline constexpr std::size_t kMaxKeeps = 20000;      //!< lines with parts that are to stay
inline constexpr std::size_t kMaxKeptParts = 20000;  //!< of one line, kept, barred or split
inline constexpr int kMaxKeptReach = 200;            //!< modules past either end of a line
inline constexpr int kMaxKeptLayer = 2;              //!< off the line
inline constexpr std::size_t kMaxPartNumber = 20;    //!< letters

}  // namespace liftarm::sketch
