#include "search/moves.h"

#include <array>

#include "search/tuning.h"

// The table of moves. A row is {name, part, weight, weight while stiffening, applies, apply}; rows
// are asked in order, each with a draw of its own, so a weight is the share of the moves that no
// row before it took.
//
// One draw among all weights would be simpler to read, but would shift every random number after
// it: all models would change, for no gain. A row that does not apply draws nothing.

namespace liftarm::search {

namespace {

bool isViolated(const SearchState& state, const MoveContext& /*context*/) {
  return state.layout().tallies().violations() > 0;
}

bool mayStir(const SearchState& /*state*/, const MoveContext& context) {
  return !context.calm;
}

bool hasFramePlaces(const SearchState& state, const MoveContext& context) {
  return !context.calm && !state.frames().useful().empty();
}

bool always(const SearchState& /*state*/, const MoveContext& /*context*/) {
  return true;
}

constexpr std::array<Move, 6> kMoves{{
    {"many", &SearchParts::many, 0.4, 0.4, isViolated, clearMany},
    {"corners", &SearchParts::corners, 0.12, 0.25, mayStir, layBend},
    {"frames", &SearchParts::frames, 0.1, 0.1, hasFramePlaces, layFrame},
    {"mirrors", &SearchParts::mirrors, 0.05, 0.05, mayStir, mirrorLayers},
    {"shifts", &SearchParts::shifts, 0.06, 0.06, mayStir, shiftPlane},
    {"cover", nullptr, 1.0, 1.0, always, coverAnew},
}};

//! How freely a move covers runs: noise varies what is cheapest, fewer layers are less work.
Manner drawManner(SearchState& state) {
  const MoveTuning& tuning = kTuning.moves;
  base::Rng& rng = state.rng();
  Manner manner;
  manner.noise = state.options().parts.noise ? tuning.mostNoise * rng.unit() : 0.0;
  manner.reach = guide::kMaxLayer;
  if (rng.unit() < tuning.nearLayers) {
    manner.reach = 1;
  } else if (rng.unit() < tuning.moreLayers) {
    manner.reach = 2;
  }
  return manner;
}

const Move& chooseMove(SearchState& state, const MoveContext& context, const MoveHabits& habits) {
  const SearchParts& parts = state.options().parts;
  for (const Move& move : kMoves) {
    const bool allowed = move.part == nullptr || parts.*move.part;
    const double weight = habits.stiffening ? move.stiffWeight : move.weight;
    if (allowed && move.applies(state, context) && (weight >= 1.0 || state.rng().unit() < weight)) {
      return move;
    }
  }
  return kMoves.back();
}

}  // namespace

std::span<const Move> moveTable() {
  return kMoves;
}

bool makeMove(SearchState& state, RunPicker& picker, const MoveHabits& habits) {
  MoveContext context;
  context.pick = picker.pick(state, habits);
  context.manner = drawManner(state);
  context.calm = state.grown() && state.layout().tallies().violations() == 0;
  return chooseMove(state, context, habits).apply(state, context);
}

}  // namespace liftarm::search
