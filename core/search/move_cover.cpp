#include "search/cover_steps.h"
#include "search/moves.h"

namespace liftarm::search {

bool coverAnew(SearchState& state, const MoveContext& context) {
  const int run = context.pick.run;
  bool changed = recover(state, run, context.manner);
  if (state.options().parts.pairs && !context.calm && state.rng().unit() < kTuning.moves.two) {
    if (const std::optional<int> partner = pickPartner(state, run)) {
      changed = recover(state, *partner, context.manner) || changed;
    }
  }
  return changed;
}

}  // namespace liftarm::search
