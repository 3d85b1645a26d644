#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace liftarm::base {

//! \brief A number of a run, junction, node or the like as a place in a list. \pre i >= 0.
constexpr std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

//! \brief Whether a short list has a number.
inline bool contains(const std::vector<int>& list, int number) {
  return std::find(list.begin(), list.end(), number) != list.end();
}

}  // namespace liftarm::base
