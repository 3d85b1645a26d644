#pragma once

#include <span>
#include <string_view>

#include "search/run_picker.h"

namespace liftarm::search {

//! \brief What one move is given.
struct MoveContext {
  Pick pick;  //!< where it begins
  Manner manner;
  bool calm = false;  //!< what grew from an earlier layout is to stay, beyond what was touched
};

//! \brief A kind of move.
struct Move {
  std::string_view name;
  bool SearchParts::*part;  //!< what switches it off (kSearchSwitches); null: nothing does
  double weight;            //!< share of the moves that come as far as its row
  double stiffWeight;       //!< the same while the search stiffens
  bool (*applies)(const SearchState& state, const MoveContext& context);
  //! Changes covers; nothing is settled. \return Whether it did: if not, the layout is to be
  //! reverted.
  bool (*apply)(SearchState& state, const MoveContext& context);
};

//! \brief All moves. A row is asked after those before it; the last one always applies.
std::span<const Move> moveTable();

//! \brief Picks a run and a move, and makes it. \return Whether covers changed.
bool makeMove(SearchState& state, RunPicker& picker, const MoveHabits& habits);

// The moves, each in a file of its own.

//! \brief Covers the run anew, and often one that it meets. (move_cover.cpp)
bool coverAnew(SearchState& state, const MoveContext& context);

//! \brief Ruin and recreate: clears the run and some that meet or pass near it, then covers them
//! one by one in a random order. What one run alone cannot do, since its neighbours stand in the
//! way, several can. (move_many.cpp)
bool clearMany(SearchState& state, const MoveContext& context);

//! \brief Lays a bent beam where the run and another meet. (move_bend.cpp)
bool layBend(SearchState& state, const MoveContext& context);

//! \brief Lays a frame at some place where it may save beams. What lies in its way goes, and the
//! rest of its runs is covered anew. (move_frame.cpp)
bool layFrame(SearchState& state, const MoveContext& context);

//! \brief Mirrors the layers of a run, and lets all that cross it follow: where lines change
//! layers, in a grid, is a wall across many lines, which no line can move alone. (move_mirror.cpp)
bool mirrorLayers(SearchState& state, const MoveContext& context);

//! \brief Shifts a component's layers by one or turns it over, its images with it: what no move of
//! single runs can do, since beams that cross must stay on layers of their own. (move_shift.cpp)
bool shiftPlane(SearchState& state, const MoveContext& context);

}  // namespace liftarm::search
