#include "sketch/point_symmetry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "base/index.h"
#include "sketch/point_index.h"
#include "sketch/sketch_json.h"

namespace liftarm::sketch {

namespace {

using base::at;
using lattice::Mat3;
using lattice::Vec3;

constexpr double kOnLine = 0.1;  // modules, least distance of two directions' cross
constexpr std::size_t kMostCandidates = 4000;

//! Three directions square to each other: along a, towards b, across both.
Mat3 frame(Vec3 a, Vec3 b) {
  const Vec3 x = lattice::normalized(a);
  const Vec3 z = lattice::normalized(lattice::cross(a, b));
  return lattice::fromColumns(x, lattice::cross(z, x), z);
}

//! One unit edge with what its lines ask for.
struct NodeEdge {
  int from = -1;
  int to = -1;
  bool exact = false;
  int holeAxis = -1;
};

//! The nodes and edges of a piece, numbered anew.
class NodeSet {
 public:
  NodeSet(const Arrangement& arrangement, int piece) : index_(kLengthTolerance) {
    std::vector<int> number(arrangement.nodes.size(), -1);
    for (const Run& run : arrangement.runs) {
      if (piece >= 0 && run.piece != piece) {
        continue;
      }
      for (std::size_t i = 0; i < run.nodes.size(); ++i) {
        int& id = number[at(run.nodes[i])];
        if (id < 0) {
          id = index_.insert(arrangement.nodes[at(run.nodes[i])].position);
          degrees_.push_back(0);
        }
        if (i > 0) {
          const ArrangedEdge& edge = run.edges[i - 1];
          addEdge({number[at(run.nodes[i - 1])],
                   id,
                   edge.exact,
                   edge.holeAxis ? lattice::index(*edge.holeAxis) : -1});
        }
      }
    }
    for (const ArrangedJoint& joint : arrangement.joints) {
      if (number[at(joint.node)] >= 0) {
        joints_.emplace_back(number[at(joint.node)], lattice::normalized(joint.axis));
      }
    }
    for (int i = 0; i < size(); ++i) {
      centre_ = centre_ + node(i);
    }
    centre_ = size() > 0 ? (1.0 / static_cast<double>(size())) * centre_ : centre_;
  }

  [[nodiscard]] int size() const { return index_.size(); }

  [[nodiscard]] Vec3 node(int i) const { return index_.at(i); }

  [[nodiscard]] Vec3 centre() const { return centre_; }

  [[nodiscard]] Vec3 arm(int i) const { return node(i) - centre_; }

  //! Nodes by their distance to the centre and their number of edges; alike ones in one class.
  [[nodiscard]] std::vector<std::vector<int>> classes() const {
    std::vector<std::pair<double, int>> order;
    for (int i = 0; i < size(); ++i) {
      order.emplace_back(lattice::length(arm(i)), i);
    }
    std::sort(order.begin(), order.end());
    std::vector<std::vector<int>> found;
    for (std::size_t begin = 0; begin < order.size();) {
      std::size_t end = begin + 1;
      while (end < order.size() && order[end].first - order[end - 1].first < kLengthTolerance) {
        ++end;
      }
      // In one shell: by degree.
      std::vector<std::pair<int, int>> shell;
      for (std::size_t i = begin; i < end; ++i) {
        shell.emplace_back(degrees_[at(order[i].second)], order[i].second);
      }
      std::sort(shell.begin(), shell.end());
      for (std::size_t i = 0; i < shell.size(); ++i) {
        if (i == 0 || shell[i].first != shell[i - 1].first) {
          found.emplace_back();
        }
        found.back().push_back(shell[i].second);
      }
      begin = end;
    }
    return found;
  }

  //! The node that each one falls on; empty when the map is no symmetry.
  [[nodiscard]] std::vector<int> images(const PointIsometry& map) const {
    std::vector<int> image;
    for (int i = 0; i < size(); ++i) {
      const int found = index_.find(map.apply(node(i)));
      if (found < 0 || degrees_[at(found)] != degrees_[at(i)]) {
        return {};
      }
      image.push_back(found);
    }
    const bool edgesFit = std::all_of(edges_.begin(), edges_.end(), [&](const NodeEdge& edge) {
      const auto found = edgeAt_.find(key(image[at(edge.from)], image[at(edge.to)]));
      return found != edgeAt_.end() && sameRules(edge, edges_[found->second], map.linear);
    });
    return edgesFit && jointsFit(image, map.linear) ? image : std::vector<int>{};
  }

 private:
  static std::uint64_t key(int a, int b) {
    return static_cast<std::uint64_t>(std::min(a, b)) << 32U |
           static_cast<std::uint64_t>(std::max(a, b));
  }

  void addEdge(const NodeEdge& edge) {
    ++degrees_[at(edge.from)];
    ++degrees_[at(edge.to)];
    edgeAt_.emplace(key(edge.from, edge.to), edges_.size());
    edges_.push_back(edge);
  }

  static bool sameRules(const NodeEdge& a, const NodeEdge& b, const Mat3& linear) {
    if (a.exact != b.exact || (a.holeAxis < 0) != (b.holeAxis < 0)) {
      return false;
    }
    return a.holeAxis < 0 ||
           std::abs((linear *
                     lattice::unitVector(lattice::axisFromIndex(a.holeAxis)))[b.holeAxis]) > 0.99;
  }

  [[nodiscard]] bool jointsFit(const std::vector<int>& image, const Mat3& linear) const {
    return std::all_of(joints_.begin(), joints_.end(), [&](const auto& joint) {
      const Vec3 axis = linear * joint.second;
      return std::any_of(joints_.begin(), joints_.end(), [&](const auto& other) {
        return other.first == image[at(joint.first)] &&
               std::abs(lattice::dot(axis, other.second)) > 0.99;
      });
    });
  }

  PointIndex index_;
  Vec3 centre_;
  std::vector<int> degrees_;
  std::vector<NodeEdge> edges_;
  std::unordered_map<std::uint64_t, std::size_t> edgeAt_;  // looked up only
  std::vector<std::pair<int, Vec3>> joints_;
};

//! Rounds entries that are nearly 0, 1 or a half, which drawings mean.
Mat3 tidied(Mat3 a) {
  for (double& entry : a.m) {
    const double halves = std::floor(2.0 * entry + 0.5) / 2.0;
    entry = std::abs(entry - halves) < 1e-6 ? halves : entry;
  }
  return a;
}

//! Tries the isometries that bring one node to `first` and another to `second`.
struct Candidates {
  const NodeSet& nodes;
  std::vector<PointIsometry> found;
  std::vector<std::vector<int>> effects;  //!< images by isometry, and the determinant at the end

  void tryLinear(const Mat3& linear) {
    const PointIsometry map{tidied(linear), nodes.centre()};
    std::vector<int> image = nodes.images(map);
    if (image.empty()) {
      return;
    }
    bool moves = false;
    for (int i = 0; i < nodes.size(); ++i) {
      moves = moves || image[at(i)] != i;
    }
    image.push_back(lattice::determinant(map.linear) > 0.0 ? 1 : -1);
    if (moves && std::find(effects.begin(), effects.end(), image) == effects.end()) {
      effects.push_back(std::move(image));
      found.push_back(map);
    }
  }

  void tryPair(Vec3 p, Vec3 q, Vec3 pImage, Vec3 qImage) {
    if (std::abs(lattice::dot(p, q) - lattice::dot(pImage, qImage)) >
        kLengthTolerance * (lattice::length(p) + lattice::length(q))) {
      return;
    }
    if (lattice::length(lattice::cross(pImage, qImage)) < kOnLine) {
      return;
    }
    const Mat3 from = lattice::transposed(frame(p, q));
    const Mat3 to = frame(pImage, qImage);
    Mat3 mirrored = to;
    for (const std::size_t row : {2U, 5U, 8U}) {
      mirrored.m[row] = -mirrored.m[row];
    }
    tryLinear(to * from);
    tryLinear(mirrored * from);
  }
};

}  // namespace

PointIsometry isometryOf(const Symmetry& symmetry) {
  const Vec3 a = symmetry.normal;
  PointIsometry isometry;
  const bool mirror = symmetry.kind == Symmetry::Kind::kReflection;
  isometry.centre = mirror ? symmetry.offset * a : symmetry.vector;
  // Of p - centre: a mirror turns the part along a round, a half turn keeps that alone.
  const double along = symmetry.order == 2 || mirror ? 2.0 : 1.0;
  const double rest = symmetry.order == 2 || mirror ? 1.0 : 0.0;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      const double kept = along * a[i] * a[k] - (i == k ? rest : 0.0);
      isometry.linear.m[at(3 * i + k)] = mirror ? -kept : kept;
    }
  }
  if (!mirror && symmetry.order == 4) {
    const std::array<double, 9> turned{0, -a.z, a.y, a.z, 0, -a.x, -a.y, a.x, 0};
    for (std::size_t i = 0; i < turned.size(); ++i) {
      isometry.linear.m[i] += turned[i];
    }
  }
  return isometry;
}

std::vector<PointIsometry> pointSymmetries(const Arrangement& arrangement, int piece) {
  const NodeSet nodes(arrangement, piece);
  std::vector<std::vector<int>> classes = nodes.classes();
  classes.erase(std::remove_if(classes.begin(),
                               classes.end(),
                               [&](const std::vector<int>& c) {
                                 return lattice::length(nodes.arm(c.front())) <
                                        4.0 * kLengthTolerance;
                               }),
                classes.end());
  std::stable_sort(classes.begin(), classes.end(), [](const auto& a, const auto& b) {
    return a.size() < b.size();
  });
  Candidates candidates{nodes, {}, {}};
  if (classes.empty()) {
    return {};
  }
  const Vec3 p = nodes.arm(classes.front().front());
  for (const std::vector<int>& other : classes) {
    const auto across = std::find_if(other.begin(), other.end(), [&](int i) {
      return lattice::length(lattice::cross(p, nodes.arm(i))) >
             kOnLine * std::max(1.0, lattice::length(p));
    });
    if (across == other.end()) {
      continue;
    }
    if (classes.front().size() * other.size() > kMostCandidates) {
      return {};
    }
    for (const int first : classes.front()) {
      for (const int second : other) {
        candidates.tryPair(p, nodes.arm(*across), nodes.arm(first), nodes.arm(second));
      }
    }
    return candidates.found;
  }
  // All nodes on one line: its middle plane.
  const Vec3 along = lattice::normalized(p);
  Mat3 mirror;
  for (int i = 0; i < 9; ++i) {
    mirror.m[at(i)] -= 2.0 * along[i / 3] * along[i % 3];
  }
  candidates.tryLinear(mirror);
  return candidates.found;
}

bool crossesItself(const Arrangement& arrangement, const PointIsometry& map) {
  constexpr double kBeyond = 0.5;  // modules
  return std::any_of(arrangement.runs.begin(), arrangement.runs.end(), [&](const Run& run) {
    const auto length = static_cast<double>(run.edges.size());
    const Vec3 from = arrangement.nodes[at(run.nodes.front())].position;
    const Vec3 imageFrom = map.apply(from);
    const Vec3 imageDirection = map.linear * run.direction;
    const Vec3 across = lattice::cross(run.direction, imageDirection);
    const double sine = lattice::length(across);
    const Vec3 apart = imageFrom - from;
    if (sine < kOnLine || std::abs(lattice::dot(apart, across)) / sine > kLengthTolerance) {
      return false;
    }
    // from + s * direction = imageFrom + t * imageDirection.
    const double s = lattice::dot(lattice::cross(apart, imageDirection), across) / (sine * sine);
    const double t = lattice::dot(lattice::cross(apart, run.direction), across) / (sine * sine);
    return s > kBeyond && s < length - kBeyond && t > kBeyond && t < length - kBeyond;
  });
}

}  // namespace liftarm::sketch
