#include "importers/mirror_plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace liftarm::importers {

namespace {

using lattice::Vec3;

//! Kind, middle, direction and length in hundredths.
using Key = std::array<long, 8>;

Key keyOf(const parts::Feature& feature) {
  const auto hundredths = [](double x) { return std::lround(100.0 * x); };
  // A stretch has no direction.
  double sign = 1.0;
  for (int i = 2; i >= 0; --i) {
    sign = std::abs(feature.axis[i]) > 1e-6 ? (feature.axis[i] < 0.0 ? -1.0 : 1.0) : sign;
  }
  return {static_cast<long>(feature.kind),
          hundredths(feature.center.x),
          hundredths(feature.center.y),
          hundredths(feature.center.z),
          hundredths(sign * feature.axis.x),
          hundredths(sign * feature.axis.y),
          hundredths(sign * feature.axis.z),
          hundredths(feature.length)};
}

parts::Feature mirrored(parts::Feature feature, const MirrorPlane& plane) {
  feature.center[plane.axis] = 2.0 * plane.at - feature.center[plane.axis];
  feature.axis[plane.axis] = -feature.axis[plane.axis];
  return feature;
}

}  // namespace

std::optional<MirrorPlane> mirrorPlane(const parts::Part& part) {
  std::vector<Key> keys;
  for (const parts::Feature& feature : part.features) {
    keys.push_back(keyOf(feature));
  }
  for (int axis = 0; axis < 3; ++axis) {
    const MirrorPlane plane{axis, (part.boundsMin[axis] + part.boundsMax[axis]) / 2.0};
    const bool same =
        std::all_of(part.features.begin(), part.features.end(), [&](const parts::Feature& one) {
          return std::find(keys.begin(), keys.end(), keyOf(mirrored(one, plane))) != keys.end();
        });
    if (same) {
      return plane;
    }
  }
  return std::nullopt;
}

}  // namespace liftarm::importers
