#pragma once

#include <vector>

#include "analysis/coverage.h"

namespace liftarm::analysis {

//! \brief Which assembly stands for which connected part of the sketch.
struct PieceMatching {
  std::vector<int> assemblyOfPiece;  //!< -1: none
  std::vector<bool> covered;         //!< whether any edge of the piece is covered
};

//! \brief Matches assemblies to connected parts of the sketch, as many as possible and none twice
//! (augmenting paths, \cite kuhn_1955_hungarian). \details An assembly can stand for a piece whose
//! covered edges it covers, every one. \param coverage All covers of each edge.
//! \param assemblies By part, -1: none. \param pieces By line.
PieceMatching matchPieces(const std::vector<EdgeCover>& coverage,
                          const std::vector<int>& assemblies,
                          const std::vector<int>& pieces);

//! \brief Takes from each edge the covers by beams of an assembly that stands for another piece:
//! lines of two pieces may lie side by side, so that a beam could stand for either.
void keepOwnCovers(const std::vector<int>& assemblies,
                   const std::vector<int>& pieces,
                   std::vector<EdgeCover>& coverage);

}  // namespace liftarm::analysis
