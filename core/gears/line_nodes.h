#pragma once

#include <map>
#include <optional>
#include <vector>

#include "lattice/vec.h"
#include "sketch/sketch.h"

namespace liftarm::gears {

//! \brief Where the lines of a sketch are, as shafts see it.
class LineNodes {
 public:
  //! \pre The sketch outlives this.
  explicit LineNodes(const sketch::Sketch& sketch);

  //! \brief Lines that have a node there.
  [[nodiscard]] std::vector<int> at(lattice::Cell cell) const;

  //! \brief The line in whose hole a shaft along an axis can turn: the only one with a node there,
  //! across the axis, and free to have its holes along it.
  [[nodiscard]] std::optional<int> bearingAt(lattice::Cell cell, int axis) const;

  //! \brief A line that passes within a part's width of a cell without a node in it.
  [[nodiscard]] std::optional<int> passing(lattice::Cell cell) const;

  [[nodiscard]] const std::vector<lattice::Vec3>& all() const { return nodes_; }

 private:
  const sketch::Sketch& sketch_;
  std::vector<lattice::Vec3> nodes_;
  std::map<lattice::Cell, std::vector<int>> onLattice_;
};

}  // namespace liftarm::gears
