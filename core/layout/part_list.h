#pragma once

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "lattice/vec.h"

namespace liftarm::layout {

//! The catalogue's facts are rounded to 1e-5: what is nearer than this is the same, modules.
inline constexpr double kSamePlace = 1e-3;

inline bool isSamePlace(lattice::Vec3 a, lattice::Vec3 b) {
  return lattice::length(a - b) < kSamePlace;
}

//! \brief Index of the entry whose `part` is this LDraw number, or -1.
template <typename Entry>
int indexOfPart(const std::vector<Entry>& list, const std::string& part) {
  const auto found = std::find_if(
      list.begin(), list.end(), [&](const Entry& entry) { return entry.part == part; });
  return found == list.end() ? -1 : static_cast<int>(found - list.begin());
}

//! \brief All indices of a list, ascending.
template <typename Entry>
std::vector<int> indicesOf(const std::vector<Entry>& list) {
  std::vector<int> all(list.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

}  // namespace liftarm::layout
