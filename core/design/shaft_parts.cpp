#include "design/shaft_parts.h"

#include <algorithm>
#include <string>

#include "base/check.h"
#include "base/det_math.h"
#include "design/crossed_part.h"
#include "parts/gear_teeth.h"

namespace liftarm::design {

namespace {

using lattice::Vec3;

//! The axle, or the hole in the middle of a part on it.
const parts::Feature& crossOf(const parts::Part& part) {
  const auto cross =
      std::find_if(part.features.begin(), part.features.end(), [](const parts::Feature& feature) {
        return feature.wing.has_value() && feature.center == Vec3{};
      });
  LIFTARM_CHECK(cross != part.features.end(), "what sits on a shaft has a cross in its middle");
  return *cross;
}

class ShaftBuilder {
 public:
  explicit ShaftBuilder(const gears::PlannedShaft& shaft) : shaft_(shaft) {
    const Vec3 u = lattice::unitVector(lattice::axisFromIndex((shaft.axis + 1) % 3));
    const Vec3 v = lattice::unitVector(lattice::axisFromIndex((shaft.axis + 2) % 3));
    // Exactly on the lattice where it can be.
    wing_ = shaft.phase == 0.0 ? u : base::detCos(shaft.phase) * u + base::detSin(shaft.phase) * v;
  }

  //! \param slot May be half-way between two.
  [[nodiscard]] model::PlacedPart part(const std::string& id, double slot) const {
    const parts::Part* known = parts::Catalogue::builtIn().find(id);
    LIFTARM_CHECK(known != nullptr, "a part in use is in the catalogue");
    const parts::Feature& cross = crossOf(*known);
    Vec3 centre = lattice::toVec3(gears::cellOf(shaft_.axis, shaft_.at, 0));
    centre[shaft_.axis] = slot;
    const Vec3 along = lattice::unitVector(lattice::axisFromIndex(shaft_.axis));
    return {id, known->color, crossedPose(cross, cross.axis, {centre, along, wing_}), -1, 0, 0};
  }

  //! The pin in the hole of a crank's arm.
  [[nodiscard]] model::PlacedPart handle(const gears::CrankHandle& crank) const {
    const parts::Catalogue& catalogue = parts::Catalogue::builtIn();
    const model::PlacedPart arm = part(parts::kCrankArm, static_cast<double>(crank.slot));
    const parts::Part* pin = catalogue.find(parts::kCrankHandle);
    const std::vector<parts::Feature>& holes = catalogue.find(parts::kCrankArm)->features;
    const auto hole = std::find_if(holes.begin(), holes.end(), [](const parts::Feature& feature) {
      return feature.kind == parts::FeatureKind::kPinHole;
    });
    LIFTARM_CHECK(pin != nullptr && hole != holes.end(), "a crank takes a handle");
    Vec3 out;
    out[shaft_.axis] = static_cast<double>(crank.side);
    const Vec3 along = pin->features.front().axis;  // of its own frame: x, either way
    const lattice::Mat3 rotation =
        lattice::fromColumns(along.x * out, wing_, lattice::cross(along.x * out, wing_));
    const Vec3 middle = arm.pose.apply(hole->center) + 0.5 * out;
    return {pin->id, pin->color, {middle, rotation}, -1, 0, 0};
  }

 private:
  const gears::PlannedShaft& shaft_;
  Vec3 wing_;
};

}  // namespace

std::vector<model::PlacedPart> shaftParts(const gears::ShaftPlan& plan) {
  std::vector<model::PlacedPart> placed;
  for (const gears::PlannedShaft& shaft : plan.shafts) {
    const ShaftBuilder builder(shaft);
    placed.push_back(builder.part(shaft.axle, 0.5 * static_cast<double>(shaft.first + shaft.last)));
    for (const gears::Seat& seat : shaft.seats) {
      if (!seat.part.empty()) {
        placed.push_back(builder.part(seat.part, static_cast<double>(seat.slot)));
      }
    }
    for (const gears::CrankHandle& handle : shaft.handles) {
      placed.push_back(builder.handle(handle));
    }
  }
  return placed;
}

}  // namespace liftarm::design
