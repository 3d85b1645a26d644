#pragma once

#include <string>
#include <vector>

#include "analysis/coverage.h"
#include "analysis/freedoms.h"
#include "analysis/scene.h"

namespace liftarm::analysis {

//! \brief A line that would take a freedom away if it were added to the sketch.
struct Brace {
  std::vector<int> lines;  //!< the two lines that it joins
  lattice::Vec3 from;
  lattice::Vec3 to;
  std::string message;  //!< one sentence for a person
};

//! A brace is at most as long as the longest beam, modules.
inline constexpr int kLongestBrace = 14;

//! \brief Proposes braces for the motions that no joint accounts for.
//! \details Candidates join two nodes of the sketch on beams of different rigid groups; they have a
//! whole length and lie in a lattice plane. A bar allows no motion that changes the distance of its
//! ends: each brace adds that row to what is known, and the one that stretches most for its length
//! comes first. \return At most one brace per motion; fewer where no candidate helps.
std::vector<Brace> findBraces(const Scene& scene,
                              const std::vector<EdgeCover>& coverage,
                              const Freedoms& freedoms);

}  // namespace liftarm::analysis
