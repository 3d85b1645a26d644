#pragma once

#include <utility>
#include <vector>

#include "layout/layout.h"
#include "search/annealing_options.h"

namespace liftarm::search {

//! \brief What a part that covers edges is.
enum class CoverKind { kStraight, kBent, kFrame, kAxle };

//! \brief The part of a cover: how many holes a straight beam has, else its place in bentBeams(),
//! frameBeams() or axleParts().
struct CoverPart {
  CoverKind kind = CoverKind::kStraight;
  int index = 0;
};

//! \brief One part in one place, whatever its layer is.
struct TableCover {
  CoverPart part;
  int parts = 0;          //!< real ones that it is made of: two for straight beams of 4 and 6 holes
  std::vector<int> runs;  //!< that it lies on and that need a cover, ascending
  std::vector<int> edges;  //!< of the table that it covers, ascending
};

//! \brief A unit edge that some part must cover: no mechanism may bridge it.
struct TableEdge {
  int run = 0;
  int index = 0;  //!< of the edge on its run
};

//! \brief Which edges a layout may leave to mechanisms.
enum class Bridging {
  kWhereNeeded,   //!< guide::mayBridge, and every run has a cover: our search
  kWherePossible  //!< next to any junction whose runs may differ in hole axis: the paper's
};

//! \brief Everything that the search can lay, without layers: each layout is a choice of covers
//! such that every edge is covered, every run that covers name has one, and of the axles in a list
//! at most one is there. \details What the bounds on beams are made from (docs/lower-bound.md), so
//! whatever the search learns to lay must be listed here.
struct CoverTable {
  std::vector<TableEdge> edges;          //!< run after run
  std::vector<TableCover> covers;        //!< straight ones first, run after run
  std::vector<std::vector<int>> rivals;  //!< axles that would cross: indices of covers
};

//! \brief Lists the covers of a problem. \param options What may be laid: lengths, bends, frames,
//! axles, and the parts of the search that are switched on.
CoverTable makeCoverTable(const layout::LayoutProblem& problem,
                          const AnnealingOptions& options,
                          Bridging bridging = Bridging::kWhereNeeded);

}  // namespace liftarm::search
