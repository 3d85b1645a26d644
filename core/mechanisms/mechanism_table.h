#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mechanisms/mechanism.h"

namespace liftarm::mechanisms {

//! \brief A mechanism in one of its orientations, with what a search needs of it.
struct OrientedMechanism {
  Mechanism shape;
  int heads = 0;
  double cost = 0.0;  //!< parts, plus a little for each body cell: fewer and simpler is better
};

//! \brief One way to join a hole to another: the mechanism and which of its heads takes which.
struct TableEntry {
  std::int32_t mechanism = -1;
  std::int32_t headA = -1;
  std::int32_t headB = -1;
};

//! \brief All oriented mechanisms, found by the relative place and axes of two holes
//! (DESIGN 6).
class MechanismTable {
 public:
  //! \brief Holes farther apart than this along any axis are not joined.
  static constexpr int kReach = 4;

  explicit MechanismTable(const std::vector<Mechanism>& mechanisms);

  [[nodiscard]] const OrientedMechanism& oriented(int id) const {
    return oriented_[static_cast<std::size_t>(id)];
  }

  [[nodiscard]] std::size_t size() const { return oriented_.size(); }

  //! \brief Ways to join hole A to hole B, cheapest first; empty when out of reach.
  //! \param offset Middle of hole B minus middle of hole A.
  [[nodiscard]] const std::vector<TableEntry>& between(lattice::Cell offset,
                                                       lattice::Axis axisA,
                                                       lattice::Axis axisB) const;

 private:
  std::vector<OrientedMechanism> oriented_;
  std::vector<std::vector<TableEntry>> buckets_;
};

}  // namespace liftarm::mechanisms
