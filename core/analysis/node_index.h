#pragma once

#include <map>
#include <vector>

#include "analysis/coverage.h"

namespace liftarm::analysis {

//! \brief The nodes of a sketch: ends of its unit edges, one where they agree within kSameNode.
class NodeIndex {
 public:
  static constexpr double kSameNode = 0.01;  //!< modules

  explicit NodeIndex(const std::vector<EdgeCover>& edges);

  [[nodiscard]] const std::vector<lattice::Vec3>& points() const { return points_; }

  //! Indices of the edges that end at a node.
  [[nodiscard]] const std::vector<int>& edgesAt(int node) const {
    return edgesAt_[static_cast<std::size_t>(node)];
  }

  [[nodiscard]] int from(int edge) const { return from_[static_cast<std::size_t>(edge)]; }

  [[nodiscard]] int to(int edge) const { return to_[static_cast<std::size_t>(edge)]; }

 private:
  int add(lattice::Vec3 p);

  std::map<lattice::Cell, std::vector<int>> cells_;
  std::vector<lattice::Vec3> points_;
  std::vector<std::vector<int>> edgesAt_;
  std::vector<int> from_;
  std::vector<int> to_;
};

}  // namespace liftarm::analysis
