#pragma once

#include <cstddef>
#include <vector>

#include "analysis/scene.h"
#include "analysis/sweep.h"

namespace liftarm::analysis {

//! \brief Axes along which parts of a model may leave: x, y, z, then the axes of holes and heads
//! that are none of these, the most frequent first; at most kMaxAxes.
std::vector<lattice::Vec3> usefulAxes(const Scene& scene);

inline constexpr std::size_t kMaxAxes = 10;

//! \brief For each direction and part, the parts that it would hit on its way to infinity: the
//! directional blocking graphs of \cite wilson_1994_geometric.
//! \details Pairs are found by a sweep over their shadows across the direction, then tested
//! exactly. Parts that overlap in their places do not block each other: that is told elsewhere, and
//! nothing could be said about the rest. What blocks two parts never changes while others leave, so
//! this is computed once.
class BlockingGraph {
 public:
  //! Refers to nothing of the scene afterwards.
  BlockingGraph(const Scene& scene, const Sweep& sweep);

  //! \brief Unit vectors; 2k + 1 is the opposite of 2k.
  [[nodiscard]] const std::vector<lattice::Vec3>& directions() const { return directions_; }

  //! \brief The parts in the way of a part, ascending. A part j is among the blockers of i along d
  //! just when i is among those of j along -d.
  [[nodiscard]] const std::vector<int>& blockers(int direction, int part) const {
    return blockers_[static_cast<std::size_t>(direction)][static_cast<std::size_t>(part)];
  }

 private:
  void addAxis(lattice::Vec3 axis, std::size_t parts, const Sweep& sweep);

  std::vector<lattice::Vec3> directions_;
  std::vector<std::vector<std::vector<int>>> blockers_;
};

}  // namespace liftarm::analysis
