#include "analysis/interpenetration.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "analysis/convex.h"

namespace liftarm::analysis {

namespace {

using lattice::Vec3;
using Kind = Shape::Kind;

//! (part with the head, feature, slot, part with the hole).
using HeadInPart = std::tuple<int, int, int, int>;

//! (part with the hole, feature, slot) of the hole slots that a head sits in.
using HoleSlot = std::tuple<int, int, int>;

class Collisions {
 public:
  explicit Collisions(const Scene& scene) : scene_(scene) {
    for (const model::Connection& c : scene.connections) {
      seated_.insert({c.male, c.maleFeature, c.maleSlot, c.female});
      if (!isGood(c.fit)) {
        badlySeated_.insert({c.male, c.female});
      }
    }
  }

  [[nodiscard]] bool collide(int a, int b, Vec3& at) const {
    const ScenePart& first = scene_.parts[static_cast<std::size_t>(a)];
    const ScenePart& second = scene_.parts[static_cast<std::size_t>(b)];
    double tolerance = kPenetration;
    if (first.part->partClass == parts::PartClass::kGear &&
        second.part->partClass == parts::PartClass::kGear) {
      tolerance += 2 * kToothHeight;
    }
    for (const Shape& s : first.shapes) {
      for (const Shape& t : second.shapes) {
        if (overlap(s.prism, t.prism, tolerance) && !excused(a, s, b, t)) {
          at = 0.25 * (s.prism.from + s.prism.to + t.prism.from + t.prism.to);
          return true;
        }
      }
    }
    return false;
  }

 private:
  [[nodiscard]] bool excused(int a, const Shape& s, int b, const Shape& t) const {
    if (s.kind != Kind::kBody && t.kind != Kind::kBody && shareHole(a, b)) {
      return true;
    }
    return (s.kind == Kind::kHead && seatedIn(a, s, b)) ||
           (t.kind == Kind::kHead && seatedIn(b, t, a)) ||
           (s.kind == Kind::kCollar && collarFits(a, s, b)) ||
           (t.kind == Kind::kCollar && collarFits(b, t, a));
  }

  [[nodiscard]] bool seatedIn(int part, const Shape& head, int other) const {
    return seated_.count({part, head.feature, head.slot, other}) > 0;
  }

  //! Two heads in one hole slot are an error of item 3, and not told twice.
  [[nodiscard]] bool shareHole(int a, int b) const {
    std::set<HoleSlot> ofA;
    std::set<HoleSlot> ofB;
    for (const model::Connection& c : scene_.connections) {
      if (c.male == a || c.male == b) {
        (c.male == a ? ofA : ofB).insert({c.female, c.femaleFeature, c.femaleSlot});
      }
    }
    return std::any_of(
        ofA.begin(), ofA.end(), [&](const HoleSlot& hole) { return ofB.count(hole) > 0; });
  }

  //! A head in a hole that does not take it is an error of item 3, and its collar is not told
  //! again.
  [[nodiscard]] bool collarFits(int part, const Shape& collar, int other) const {
    return badlySeated_.count({part, other}) > 0 || inRim(collar, other);
  }

  //! Whether a collar lies in the rim of one of the other part's pin holes.
  [[nodiscard]] bool inRim(const Shape& collar, int other) const {
    const auto i = static_cast<std::size_t>(other);
    const lattice::Pose& pose = scene_.model->parts[i].pose;
    for (const parts::Feature& feature : scene_.parts[i].part->features) {
      if (feature.kind != parts::FeatureKind::kPinHole) {
        continue;
      }
      const Vec3 axis = pose.rotation * feature.axis;
      const double half = feature.length / static_cast<double>(feature.slots.size()) / 2;
      for (const Vec3 slot : feature.slots) {
        if (rimHolds(collar.prism, pose.apply(slot), axis, half)) {
          return true;
        }
      }
    }
    return false;
  }

  static bool rimHolds(const parts::Prism& collar, Vec3 hole, Vec3 axis, double half) {
    const Vec3 offset = collar.from - hole;
    const double along = lattice::dot(offset, axis);
    if (std::abs(lattice::dot(collar.axis, axis)) < model::kCoaxialCosine ||
        lattice::length(offset - along * axis) > model::kCoaxialDistance) {
      return false;
    }
    const double depth = half - (std::abs(along) - collar.halfThickness);
    return depth <= kCounterbore + kPenetration;
  }

  const Scene& scene_;
  std::set<HeadInPart> seated_;
  std::set<std::pair<int, int>> badlySeated_;  // (part with the head, part with the hole)
};

//! Pairs of parts whose boxes meet, smaller index first, by a sweep along x.
std::vector<std::pair<int, int>> nearPairs(const Scene& scene) {
  std::vector<int> order(scene.parts.size());
  std::iota(order.begin(), order.end(), 0);
  const auto box = [&](int i) -> const Box& {
    return scene.parts[static_cast<std::size_t>(i)].box;
  };
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return std::pair(box(a).min.x, a) < std::pair(box(b).min.x, b);
  });
  std::vector<std::pair<int, int>> pairs;
  std::vector<int> active;
  for (const int i : order) {
    active.erase(
        std::remove_if(
            active.begin(), active.end(), [&](int j) { return box(j).max.x <= box(i).min.x; }),
        active.end());
    for (const int j : active) {
      if (meet(box(i), box(j), kPenetration)) {
        pairs.emplace_back(std::min(i, j), std::max(i, j));
      }
    }
    active.push_back(i);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

void findCollisions(const Scene& scene, ItemResult& result) {
  const Collisions collisions(scene);
  for (const auto& [a, b] : nearPairs(scene)) {
    Vec3 at;
    if (collisions.collide(a, b, at)) {
      result.problems.push_back({"collision",
                                 nameOf(scene, a) + " and " + nameOf(scene, b) +
                                     " take the same space near " + pointText(at),
                                 at,
                                 {a, b}});
    }
  }
}

//! The unit cells of a keep-out box as one box; empty where no cell's middle lies in it.
Box cellsOf(const sketch::KeepOut& keepOut) {
  constexpr double kRounding = 1e-6;
  Box box;
  for (int i = 0; i < 3; ++i) {
    box.min[i] = std::ceil(keepOut.min[i] - kRounding) - 0.5;
    box.max[i] = std::floor(keepOut.max[i] + kRounding) + 0.5;
  }
  return box;
}

bool enters(const ScenePart& part, const Box& box) {
  return std::any_of(part.shapes.begin(), part.shapes.end(), [&](const Shape& shape) {
    return overlap(shape.prism, box, kPenetration);
  });
}

void findForbiddenPlaces(const Scene& scene, ItemResult& result) {
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const int index = static_cast<int>(i);
    const Vec3 at = scene.model->parts[i].pose.position;
    for (const sketch::KeepOut& box : scene.sketch->keepOut) {
      if (enters(scene.parts[i], cellsOf(box))) {
        result.problems.push_back({"keepOut",
                                   nameOf(scene, index) + " enters the keep-out box from " +
                                       pointText(box.min) + " to " + pointText(box.max),
                                   at,
                                   {index}});
      }
    }
    const bool below =
        scene.sketch->ground.has_value() &&
        std::any_of(
            scene.parts[i].shapes.begin(), scene.parts[i].shapes.end(), [&](const Shape& shape) {
              return std::min(shape.prism.from.z, shape.prism.to.z) <
                     *scene.sketch->ground - kGroundTolerance;
            });
    if (below) {
      result.problems.push_back(
          {"ground", nameOf(scene, index) + " lies below the ground", at, {index}});
    }
  }
}

}  // namespace

ItemResult checkInterpenetration(const Scene& scene) {
  ItemResult result;
  findCollisions(scene, result);
  const std::size_t collisions = result.problems.size();
  if (scene.sketch.has_value()) {
    findForbiddenPlaces(scene, result);
  }
  result.detail = std::to_string(collisions) + " collisions, " +
                  std::to_string(result.problems.size() - collisions) +
                  " parts in forbidden places";
  return result;
}

}  // namespace liftarm::analysis
