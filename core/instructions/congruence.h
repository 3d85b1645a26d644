#pragma once

#include <optional>
#include <vector>

#include "analysis/scene.h"

namespace liftarm::instructions {

//! \brief How one set of parts is another one over again.
struct Match {
  std::vector<int> parts;  //!< of the second set, in the order of the first
  bool mirrored = false;   //!< a reflection, not a turn, takes one to the other
  lattice::Pose pose;      //!< takes the first to the second, unless mirrored
};

//! \brief Whether two sets are the same but for one of the 24 turns of the lattice, a shift and, as
//! a last resort, a reflection.
//! \details Parts are compared by number and by where their holes, heads and collars are, so that a
//! beam may lie the other way round. Colours may differ.
std::optional<Match> findMatch(const analysis::Scene& scene,
                               const std::vector<int>& first,
                               const std::vector<int>& second);

//! \brief Flat frames that occur more than once: beams joined by straight pins, and the pins that
//! hold nothing else. Disjoint; each at most half of the model.
std::vector<std::vector<int>> findRepeatedFrames(const analysis::Scene& scene);

}  // namespace liftarm::instructions
