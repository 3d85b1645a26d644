#include "analysis/frame_skeleton.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "analysis/materials.h"
#include "analysis/union_find.h"

namespace liftarm::analysis {

namespace {

using lattice::Vec3;
using parts::FeatureKind;

constexpr double kOnePoint = 0.06;  // modules: points nearer than this are one

class SkeletonBuilder {
 public:
  explicit SkeletonBuilder(const parts::Part& part) : part_(part) {}

  Skeleton build() {
    addPoints();
    for (const parts::Prism& prism : part_.solid) {
      addArm(prism);
    }
    for (std::size_t f = 0; f < part_.features.size(); ++f) {
      const std::vector<int>& slots = skeleton_.pointOfSlot[f];
      for (std::size_t s = 1; s < slots.size(); ++s) {
        addEdge(slots[s - 1], slots[s], part_.features[f].axis);
      }
    }
    joinPieces();
    return std::move(skeleton_);
  }

 private:
  int pointAt(Vec3 at) {
    for (std::size_t i = 0; i < skeleton_.points.size(); ++i) {
      if (lattice::length(skeleton_.points[i] - at) < kOnePoint) {
        return static_cast<int>(i);
      }
    }
    skeleton_.points.push_back(at);
    kinds_.push_back(StretchKind::kBody);
    return static_cast<int>(skeleton_.points.size()) - 1;
  }

  void addPoints() {
    for (const parts::Feature& feature : part_.features) {
      std::vector<int> slots;
      for (const Vec3 at : feature.slots) {
        const int point = pointAt(at);
        slots.push_back(point);
        if (parts::isMale(feature.kind)) {
          kinds_[static_cast<std::size_t>(point)] =
              feature.kind == FeatureKind::kPin ? StretchKind::kPin : StretchKind::kAxle;
        }
      }
      skeleton_.pointOfSlot.push_back(slots);
    }
    for (const parts::Prism& prism : part_.solid) {
      if (lattice::length(prism.to - prism.from) > kOnePoint) {
        pointAt(prism.from);
        pointAt(prism.to);
      }
    }
    if (skeleton_.points.empty()) {
      pointAt({});
    }
  }

  //! Chains the points on one arm of the body.
  void addArm(const parts::Prism& prism) {
    const Vec3 along = prism.to - prism.from;
    const double length = lattice::length(along);
    if (length < kOnePoint) {
      return;
    }
    const Vec3 direction = (1.0 / length) * along;
    std::vector<std::pair<double, int>> on;
    for (std::size_t i = 0; i < skeleton_.points.size(); ++i) {
      const Vec3 offset = skeleton_.points[i] - prism.from;
      const double t = lattice::dot(offset, direction);
      if (t > -kOnePoint && t < length + kOnePoint &&
          lattice::length(offset - t * direction) < kOnePoint) {
        on.emplace_back(t, static_cast<int>(i));
      }
    }
    std::sort(on.begin(), on.end());
    for (std::size_t i = 1; i < on.size(); ++i) {
      if (addEdge(on[i - 1].second, on[i].second, prism.axis)) {
        SkeletonEdge& edge = skeleton_.edges.back();
        edge.width = 2.0 * prism.radius * kMillimetresPerModule;
        edge.depth = 2.0 * prism.halfThickness * kMillimetresPerModule;
      }
    }
  }

  //! \return False where the two points have a stretch already.
  bool addEdge(int a, int b, Vec3 up) {
    const StretchKind atA = kinds_[static_cast<std::size_t>(a)];
    const StretchKind atB = kinds_[static_cast<std::size_t>(b)];
    SkeletonEdge edge;
    edge.a = a;
    edge.b = b;
    edge.kind = atA == StretchKind::kBody ? atB : atA;
    edge.up = up;
    const bool known =
        std::any_of(skeleton_.edges.begin(), skeleton_.edges.end(), [&](const SkeletonEdge& other) {
          return (other.a == a && other.b == b) || (other.a == b && other.b == a);
        });
    if (!known) {
      skeleton_.edges.push_back(edge);
    }
    return !known;
  }

  [[nodiscard]] Vec3 upAt(int point) const {
    for (std::size_t f = 0; f < part_.features.size(); ++f) {
      const std::vector<int>& slots = skeleton_.pointOfSlot[f];
      if (std::find(slots.begin(), slots.end(), point) != slots.end()) {
        return part_.features[f].axis;
      }
    }
    return {0, 0, 1};
  }

  //! Joins what is still apart by the shortest stretches.
  void joinPieces() {
    const std::size_t count = skeleton_.points.size();
    UnionFind pieces(count);
    for (const SkeletonEdge& edge : skeleton_.edges) {
      pieces.join(edge.a, edge.b);
    }
    std::vector<std::pair<double, std::pair<int, int>>> gaps;
    for (int a = 0; a < static_cast<int>(count); ++a) {
      for (int b = a + 1; b < static_cast<int>(count); ++b) {
        if (pieces.find(a) != pieces.find(b)) {
          const Vec3 apart = skeleton_.points[static_cast<std::size_t>(b)] -
                             skeleton_.points[static_cast<std::size_t>(a)];
          gaps.push_back({lattice::length(apart), {a, b}});
        }
      }
    }
    std::sort(gaps.begin(), gaps.end());
    for (const auto& [distance, ends] : gaps) {
      if (pieces.find(ends.first) != pieces.find(ends.second)) {
        addEdge(ends.first, ends.second, upAt(ends.first));
        pieces.join(ends.first, ends.second);
      }
    }
  }

  const parts::Part& part_;
  Skeleton skeleton_;
  std::vector<StretchKind> kinds_;  // of points: what a stretch to them is made of
};

bool continues(const Skeleton& skeleton, const SkeletonEdge& in, const SkeletonEdge& out) {
  const auto direction = [&](const SkeletonEdge& edge) {
    return lattice::normalized(skeleton.points[static_cast<std::size_t>(edge.b)] -
                               skeleton.points[static_cast<std::size_t>(edge.a)]);
  };
  constexpr double kStraight = 1e-6;
  return in.kind == out.kind && in.width == out.width && in.depth == out.depth &&
         lattice::length(lattice::cross(direction(in), direction(out))) < kStraight;
}

}  // namespace

Skeleton skeletonOf(const parts::Part& part) {
  return SkeletonBuilder(part).build();
}

void simplify(Skeleton& skeleton, const std::vector<bool>& keep) {
  for (std::size_t point = 0; point < skeleton.points.size(); ++point) {
    if (keep[point]) {
      continue;
    }
    const int p = static_cast<int>(point);
    std::vector<std::size_t> at;
    for (std::size_t e = 0; e < skeleton.edges.size(); ++e) {
      if (skeleton.edges[e].a == p || skeleton.edges[e].b == p) {
        at.push_back(e);
      }
    }
    if (at.size() != 2 || !continues(skeleton, skeleton.edges[at[0]], skeleton.edges[at[1]])) {
      continue;
    }
    SkeletonEdge& first = skeleton.edges[at[0]];
    const SkeletonEdge& second = skeleton.edges[at[1]];
    const int far = second.a == p ? second.b : second.a;
    (first.a == p ? first.a : first.b) = far;
    skeleton.edges.erase(skeleton.edges.begin() + static_cast<std::ptrdiff_t>(at[1]));
  }
}

}  // namespace liftarm::analysis
