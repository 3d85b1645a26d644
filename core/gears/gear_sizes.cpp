#include "gears/gear_sizes.h"

#include <algorithm>

#include "parts/gear_teeth.h"

namespace liftarm::gears {

namespace {

bool fillsASlot(const parts::Part& part) {
  return std::any_of(part.features.begin(), part.features.end(), [](const parts::Feature& hole) {
    return hole.kind == parts::FeatureKind::kAxleHole && hole.length == 1.0 &&
           hole.center == lattice::Vec3{};
  });
}

}  // namespace

std::vector<GearSize> gearSizesOf(const std::vector<parts::Part>& parts) {
  std::vector<GearSize> sizes;
  for (const parts::Part& part : parts) {
    const int teeth = parts::teethOf(part);
    const bool known = std::any_of(
        sizes.begin(), sizes.end(), [&](const GearSize& size) { return size.teeth == teeth; });
    if (teeth > 0 && fillsASlot(part) && !known) {
      sizes.push_back({teeth, part.id});
    }
  }
  std::sort(sizes.begin(), sizes.end(), [](const GearSize& a, const GearSize& b) {
    return a.teeth < b.teeth;
  });
  return sizes;
}

}  // namespace liftarm::gears
