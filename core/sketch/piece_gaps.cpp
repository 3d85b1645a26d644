#include "sketch/piece_gaps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>

namespace liftarm::sketch {

namespace {

using lattice::Vec3;

constexpr std::int64_t kMaxGapComparisons = 20'000'000;

struct PieceNode {
  Vec3 position;
  int piece = -1;
  int id = -1;
};

//! The axis along which the nodes lie farthest apart.
int longestAxis(const std::vector<PieceNode>& nodes) {
  int longest = 0;
  double most = -1.0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::minmax_element(
        nodes.begin(), nodes.end(), [axis](const PieceNode& a, const PieceNode& b) {
          return a.position[axis] < b.position[axis];
        });
    const double extent = high->position[axis] - low->position[axis];
    if (extent > most) {
      most = extent;
      longest = axis;
    }
  }
  return longest;
}

//! All nodes, in order along one axis, so that the near ones lie side by side.
class NodesInOrder {
 public:
  explicit NodesInOrder(const Arrangement& arrangement) {
    for (std::size_t n = 0; n < arrangement.nodes.size(); ++n) {
      const int run = arrangement.nodes[n].runs.front().first;
      nodes_.push_back({arrangement.nodes[n].position,
                        arrangement.runs[static_cast<std::size_t>(run)].piece,
                        static_cast<int>(n)});
    }
    axis_ = longestAxis(nodes_);
    std::sort(nodes_.begin(), nodes_.end(), [this](const PieceNode& a, const PieceNode& b) {
      return std::make_tuple(a.position[axis_], a.id) < std::make_tuple(b.position[axis_], b.id);
    });
  }

  //! The nearest nodes of a piece and of any other; nothing when that takes too long.
  std::optional<PieceGap> gapOf(int piece) {
    double best = std::numeric_limits<double>::infinity();
    PieceGap gap;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (nodes_[i].piece != piece) {
        continue;
      }
      for (const int way : {-1, 1}) {
        for (std::size_t j = i + static_cast<std::size_t>(way); j < nodes_.size();
             j += static_cast<std::size_t>(way)) {
          if (++comparisons_ > kMaxGapComparisons) {
            return std::nullopt;
          }
          const Vec3 span = nodes_[j].position - nodes_[i].position;
          if (std::abs(span[axis_]) >= best) {
            break;
          }
          if (nodes_[j].piece != piece && lattice::length(span) < best) {
            best = lattice::length(span);
            gap = {piece, -1, nodes_[j].piece, -1, nodes_[i].position, nodes_[j].position};
          }
        }
      }
    }
    return gap;
  }

 private:
  std::vector<PieceNode> nodes_;
  int axis_ = 0;
  std::int64_t comparisons_ = 0;
};

int firstRun(const Arrangement& arrangement, int piece) {
  const auto found = std::find_if(arrangement.runs.begin(),
                                  arrangement.runs.end(),
                                  [piece](const Run& run) { return run.piece == piece; });
  return static_cast<int>(found - arrangement.runs.begin());
}

}  // namespace

std::vector<PieceGap> findPieceGaps(const Arrangement& arrangement, int most) {
  std::vector<PieceGap> gaps;
  if (arrangement.pieces < 2) {
    return gaps;
  }
  NodesInOrder nodes(arrangement);
  for (int piece = 1; piece < arrangement.pieces && piece <= most; ++piece) {
    std::optional<PieceGap> gap = nodes.gapOf(piece);
    if (!gap.has_value()) {
      break;
    }
    gap->run = firstRun(arrangement, piece);
    gap->otherRun = firstRun(arrangement, gap->other);
    gaps.push_back(*gap);
  }
  return gaps;
}

}  // namespace liftarm::sketch
