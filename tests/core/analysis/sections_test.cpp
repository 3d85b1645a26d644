#include "analysis/sections.h"

#include <cmath>

#include <gtest/gtest.h>

#include "analysis/materials.h"

namespace liftarm::analysis {
namespace {

TEST(BeamSection, LiesBetweenItsWeakestSliceAndTheSolidBar) {
  const Section beam = beamSection(kBeamWidth, kBeamDepth);
  const Section solid = rectangleSection(kBeamWidth, kBeamDepth);
  EXPECT_GT(beam.area, beam.netArea);
  EXPECT_LT(beam.area, solid.area);
  EXPECT_LT(beam.inertiaY, solid.inertiaY);
  EXPECT_LT(beam.inertiaZ, solid.inertiaZ);
  EXPECT_LT(beam.torsion, solid.torsion);
  EXPECT_LT(beam.shearY, beam.shearZ);
}

TEST(BeamSection, HasTheLigamentsOfItsHoleForNetArea) {
  const Section beam = beamSection(kBeamWidth, kBeamDepth);
  const double core = (kBeamDepth - 2 * kRimDepth) * (kBeamWidth - 2 * kHoleRadius);
  const double rims = 2 * kRimDepth * (kBeamWidth - 2 * kRimRadius);
  EXPECT_NEAR(beam.netArea, core + rims, 0.05);
}

TEST(BeamSection, HalvesWithHalfTheDepth) {
  const Section full = beamSection(kBeamWidth, 8.0);
  const Section half = beamSection(kBeamWidth, 4.0);
  EXPECT_LT(half.area, 0.55 * full.area);
  EXPECT_GT(half.area, 0.35 * full.area);
  EXPECT_LT(half.inertiaY, half.area / full.area * full.inertiaY / 2);
}

TEST(BeamSection, ExplainsTheMassOfARealBeam) {
  // 32278, 15 holes, 4.27 g on scales: ABS of 1.05 g/cm3.
  const double width = kBeamWidth;
  double volume = 0.0;
  constexpr int kSteps = 400;
  for (int i = 0; i < kSteps; ++i) {
    const double x = 4.0 * (i + 0.5) / kSteps;
    const double hole = x < kHoleRadius ? 2 * std::sqrt(kHoleRadius * kHoleRadius - x * x) : 0.0;
    const double rim = x < kRimRadius ? 2 * std::sqrt(kRimRadius * kRimRadius - x * x) : 0.0;
    volume += 15 * 8.0 / kSteps *
              ((kBeamDepth - 2 * kRimDepth) * (width - hole) + 2 * kRimDepth * (width - rim));
  }
  EXPECT_NEAR(volume * 1.05e-3, 4.27, 0.1 * 4.27);
}

TEST(PinSection, IsATube) {
  const Section pin = pinSection();
  EXPECT_NEAR(pin.torsion, 2 * pin.inertiaY, 1e-12);
  EXPECT_NEAR(pin.area, 3.14159265 * (2.4 * 2.4 - 1.6 * 1.6), 1e-6);
  EXPECT_GT(pin.shearY, 0.5 * pin.area);
  EXPECT_LT(pin.shearY, pin.area);
  // Greatest over mean shear stress of a tube lies between a rod's 4/3 and a thin tube's 2.
  EXPECT_GT(pin.area / pin.netShear, 4.0 / 3.0);
  EXPECT_LT(pin.area / pin.netShear, 2.0);
}

TEST(AxleSection, IsStifferInBendingThanInTorsion) {
  const Section axle = axleSection();
  EXPECT_NEAR(axle.area, 14.04, 1e-9);
  EXPECT_LT(axle.torsion, axle.inertiaY + axle.inertiaZ);
}

TEST(RectangleSection, HasTheTorsionOfASquare) {
  EXPECT_NEAR(rectangleSection(1.0, 1.0).torsion, 0.1406, 0.0006);
  EXPECT_NEAR(rectangleSection(1.0, 10.0).torsion, 3.123, 0.02);
}

TEST(Abs, HasTheShearModulusOfAnIsotropicBody) {
  EXPECT_NEAR(kAbs.shearModulus(), 2250.0 / 2.7, 1e-9);
  EXPECT_NEAR(kAbs.shearYield(), 40.0 / std::sqrt(3.0), 1e-9);
}

}  // namespace
}  // namespace liftarm::analysis
