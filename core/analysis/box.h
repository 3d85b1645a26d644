#pragma once

#include <algorithm>

#include "lattice/vec.h"

namespace liftarm::analysis {

//! \brief An axis-aligned box, modules. Starts empty.
struct Box {
  lattice::Vec3 min{1e9, 1e9, 1e9};
  lattice::Vec3 max{-1e9, -1e9, -1e9};

  void add(const Box& other) {
    for (int i = 0; i < 3; ++i) {
      min[i] = std::min(min[i], other.min[i]);
      max[i] = std::max(max[i], other.max[i]);
    }
  }

  [[nodiscard]] bool empty() const { return max.x < min.x; }
};

//! \brief Whether two boxes share more than `tolerance` along every axis.
inline bool meet(const Box& a, const Box& b, double tolerance) {
  for (int i = 0; i < 3; ++i) {
    if (std::min(a.max[i], b.max[i]) - std::max(a.min[i], b.min[i]) <= tolerance) {
      return false;
    }
  }
  return true;
}

}  // namespace liftarm::analysis
