#pragma once

#include <optional>
#include <vector>

#include "sketch/arrangement.h"

namespace liftarm::sketch {

//! \brief A piece of a sketch and its node that is nearest to one of another piece.
struct PieceGap {
  int piece = -1;
  int run = -1;  //!< the first of the piece
  int other = -1;
  int otherRun = -1;
  lattice::Vec3 from;  //!< of the piece
  lattice::Vec3 to;    //!< of the other
};

//! \brief The gap of each piece but the first, at most so many. Where a drawing is so large that
//! the nearest nodes would take long to find, those that follow are left out.
std::vector<PieceGap> findPieceGaps(const Arrangement& arrangement, int most);

}  // namespace liftarm::sketch
