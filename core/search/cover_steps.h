#pragma once

#include <vector>

#include "search/search_state.h"
#include "search/tuning.h"

namespace liftarm::search {

//! \file
//! \brief Steps that moves are made of. Each changes covers, settles nothing, and says whether it
//! changed any.

//! \brief Covers a run anew with this hole axis; `fixed` are beams that it must contain.
bool coverRun(SearchState& state,
              int run,
              lattice::Axis axis,
              const Manner& manner,
              const std::vector<layout::Beam>& fixed);

//! \brief Covers a run anew; its arms of bent beams and frames stay, and then so does its hole
//! axis. Sometimes takes them off instead. \param turning Share of covers that turn the hole axis.
bool recover(SearchState& state,
             int run,
             const Manner& manner,
             double turning = kTuning.moves.turn);

//! \brief Takes the bent beams and frames of a run out: it and the runs of their other arms are
//! covered anew.
bool straighten(SearchState& state, int run, const Manner& manner);

//! \brief Takes off the bent beam or the frame that an arm on a run belongs to, and adds its other
//! runs to a list. What it leaves is not covered.
void takeOff(SearchState& state, int run, const layout::Beam& arm, std::vector<int>* bare);

}  // namespace liftarm::search
