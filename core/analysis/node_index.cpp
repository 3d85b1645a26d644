#include "analysis/node_index.h"

#include <cmath>

namespace liftarm::analysis {

namespace {

lattice::Cell cellOf(lattice::Vec3 p) {
  return {static_cast<int>(std::floor(p.x + 0.5)),
          static_cast<int>(std::floor(p.y + 0.5)),
          static_cast<int>(std::floor(p.z + 0.5))};
}

}  // namespace

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
  const lattice::Vec3 reach{kSameNode, kSameNode, kSameNode};
  const lattice::Cell low = cellOf(p - reach);
  const lattice::Cell high = cellOf(p + reach);
  for (int x = low.x; x <= high.x; ++x) {
    for (int y = low.y; y <= high.y; ++y) {
      for (int z = low.z; z <= high.z; ++z) {
        const auto known = cells_.find({x, y, z});
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
  cells_[cellOf(p)].push_back(node);
  return node;
}

}  // namespace liftarm::analysis
