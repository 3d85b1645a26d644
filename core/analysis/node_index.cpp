#include "analysis/node_index.h"

#include <cmath>

namespace liftarm::analysis {

NodeIndex::NodeIndex(const std::vector<EdgeCover>& edges) {
  for (const EdgeCover& edge : edges) {
    const int index = static_cast<int>(from_.size());
    from_.push_back(add(edge.from));
    to_.push_back(add(edge.to));
    edgesAt_[static_cast<std::size_t>(from_.back())].push_back(index);
    edgesAt_[static_cast<std::size_t>(to_.back())].push_back(index);
  }
}

int NodeIndex::add(lattice::Vec3 p) {
  const lattice::Cell cell{static_cast<int>(std::floor(p.x + 0.5)),
                           static_cast<int>(std::floor(p.y + 0.5)),
                           static_cast<int>(std::floor(p.z + 0.5))};
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        const auto known = cells_.find(cell + lattice::Cell{x, y, z});
        if (known == cells_.end()) {
          continue;
        }
        for (const int node : known->second) {
          if (lattice::length(points_[static_cast<std::size_t>(node)] - p) <= kSameNode) {
            return node;
          }
        }
      }
    }
  }
  const int node = static_cast<int>(points_.size());
  points_.push_back(p);
  edgesAt_.emplace_back();
  cells_[cell].push_back(node);
  return node;
}

}  // namespace liftarm::analysis
