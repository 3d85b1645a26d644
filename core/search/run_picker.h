#pragma once

#include <optional>
#include <vector>

#include "search/phase.h"

namespace liftarm::search {

//! \brief Where a move begins.
struct Pick {
  int run = 0;
  std::optional<int> junction = {};  //!< violated one that the run was picked for
};

//! \brief Another run that meets a run, at random; none where the draw falls on itself.
std::optional<int> pickPartner(SearchState& state, int run);

//! \brief Picks the runs at which moves begin: mostly where something is wrong or dear.
class RunPicker {
 public:
  explicit RunPicker(const guide::GuidingGraph& graph);

  //! \brief A run that moves and should not, one of the phase's focus, one at a violated place, one
  //! with more beams than it needs, or any: as there are such, and the dice say so.
  Pick pick(SearchState& state, const MoveHabits& habits);

 private:
  [[nodiscard]] int anyRun(SearchState& state);
  [[nodiscard]] std::optional<int> costlyRun(SearchState& state);
  [[nodiscard]] Pick violatedPlace(SearchState& state);

  std::vector<int> fewestBeams_;  // by run: a lower bound
  std::vector<int> places_;       // of one pick
};

}  // namespace liftarm::search
