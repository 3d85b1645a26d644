#include "analysis/real_parts.h"

#include <cmath>
#include <cstddef>

namespace liftarm::analysis {

namespace {

using lattice::Mat3;
using lattice::Vec3;

// Files hold rotations to six digits.
constexpr double kRotationTolerance = 1e-4;

Vec3 column(const Mat3& m, std::size_t j) {
  return {m.m[j], m.m[3 + j], m.m[6 + j]};
}

bool isProperRotation(const Mat3& m) {
  const Vec3 x = column(m, 0);
  const Vec3 y = column(m, 1);
  const Vec3 z = column(m, 2);
  return std::abs(lattice::dot(x, x) - 1.0) < kRotationTolerance &&
         std::abs(lattice::dot(y, y) - 1.0) < kRotationTolerance &&
         std::abs(lattice::dot(x, y)) < kRotationTolerance &&
         lattice::length(lattice::cross(x, y) - z) < kRotationTolerance;
}

}  // namespace

ItemResult checkRealParts(const Scene& scene) {
  ItemResult result;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const int index = static_cast<int>(i);
    const model::PlacedPart& placed = scene.model->parts[i];
    if (scene.parts[i].part == nullptr) {
      result.problems.push_back({"unknownPart",
                                 nameOf(scene, index) + " is not a part of the catalogue",
                                 placed.pose.position,
                                 {index}});
    } else if (!isProperRotation(placed.pose.rotation)) {
      result.problems.push_back(
          {"rotation",
           nameOf(scene, index) + " is mirrored, scaled or skewed: no real part is",
           placed.pose.position,
           {index}});
    }
  }
  if (scene.parts.empty()) {
    result.problems.push_back({"empty", "the model has no parts", std::nullopt, {}});
  }
  result.detail = std::to_string(scene.parts.size()) + " parts";
  return result;
}

}  // namespace liftarm::analysis
