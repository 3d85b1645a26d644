#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "lattice/vec.h"

namespace liftarm::sketch {

//! \brief Points numbered in the order of insertion and found again within a tolerance, in constant
//! expected time each. Never iterates over its hash table, so results do not depend on the
//! platform.
class PointIndex {
 public:
  //! \param tolerance Modules, positive. Points within it may be called the same.
  explicit PointIndex(double tolerance);

  //! \return The nearest point within the tolerance (of equal ones the first), or -1.
  [[nodiscard]] int find(lattice::Vec3 point) const;

  //! \return The number of the new point.
  int insert(lattice::Vec3 point);

  //! \return find(point), or the number of the point inserted in its place.
  int findOrInsert(lattice::Vec3 point);

  [[nodiscard]] const lattice::Vec3& at(int id) const {
    return points_[static_cast<std::size_t>(id)];
  }

  [[nodiscard]] int size() const { return static_cast<int>(points_.size()); }

 private:
  //! A point and how far it is from the one that is looked for.
  struct Nearest {
    int id = -1;
    double distance = 0.0;
  };

  [[nodiscard]] std::int64_t cellOf(double coordinate) const;
  void searchCell(std::uint64_t key, lattice::Vec3 point, Nearest& nearest) const;

  double tolerance_;
  double cellSize_;
  std::vector<lattice::Vec3> points_;
  std::vector<int> nextInCell_;  //!< chains of points, -1 ends one
  std::unordered_map<std::uint64_t, int> firstInCell_;
};

}  // namespace liftarm::sketch
