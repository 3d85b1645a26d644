#pragma once

#include "search/phase.h"

namespace liftarm::search {

//! \brief The first phase of a search from nothing: hole axes from stage one, then every run is
//! covered once, in order, on the layers that the walls give it (guide/layer_field).
class FirstLayout final : public Phase {
 public:
  using Phase::Phase;

  Next begin() override;
  Next endRound() override;
};

//! \brief Lays all anew with other hole axes, and without grudges: what one start cannot do another
//! may.
void layAgain(SearchState& state);

}  // namespace liftarm::search
