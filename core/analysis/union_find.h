#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace liftarm::analysis {

//! \brief Groups of indices that can be joined.
class UnionFind {
 public:
  explicit UnionFind(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  //! \return The smallest index of the group.
  [[nodiscard]] int find(int i) {
    while (parent_[static_cast<std::size_t>(i)] != i) {
      int& parent = parent_[static_cast<std::size_t>(i)];
      parent = parent_[static_cast<std::size_t>(parent)];
      i = parent;
    }
    return i;
  }

  void join(int a, int b) {
    const int x = find(a);
    const int y = find(b);
    parent_[static_cast<std::size_t>(x < y ? y : x)] = x < y ? x : y;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace liftarm::analysis
