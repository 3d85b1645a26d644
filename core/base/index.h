#pragma once

#include <cstddef>

namespace liftarm::base {

//! \brief A number of a run, junction, node or the like as a place in a list. \pre i >= 0.
constexpr std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace liftarm::base
