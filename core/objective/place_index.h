#pragma once

#include <cstdint>
#include <vector>

#include "lattice/vec.h"

namespace liftarm::objective {

//! \brief Finds what was entered at a place and along an axis, within a thousandth of a module.
//! \details Open hashing on buckets of a quarter module; a place near a bucket's wall is looked for
//! on both sides of it. Only looked up, never walked: the order of entries says nothing.
class PlaceIndex {
 public:
  PlaceIndex();

  void clear();

  //! \param value Not negative. Several may be entered at one place: find() gives the first.
  void add(lattice::Axis axis, lattice::Vec3 place, int value);

  //! \return What was entered there first, or -1.
  [[nodiscard]] int find(lattice::Axis axis, lattice::Vec3 place) const;

 private:
  struct Entry {
    lattice::Vec3 place;
    int axis = 0;
    int value = -1;
    std::int32_t next = -1;
  };

  std::vector<Entry> entries_;
  std::vector<std::int32_t> heads_;
};

}  // namespace liftarm::objective
