#include "analysis/sections.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/materials.h"

namespace liftarm::analysis {

namespace {

constexpr double kShearShare = 5.0 / 6.0;  // of a rectangle
constexpr double kPeak = 1.5;              // greatest to mean shear stress in a rectangle
constexpr int kSlices = 64;                // over half a module

double cube(double x) {
  return x * x * x;
}

//! Torsion constant of a rectangle (Roark's formula, within 4 %).
double torsionOfRectangle(double a, double b) {
  const double s = std::min(a, b);
  const double l = std::max(a, b);
  const double ratio = s / l;
  return cube(s) * l * (1.0 / 3.0 - 0.21 * ratio * (1.0 - ratio * ratio * ratio * ratio / 12.0));
}

double chord(double radius, double x) {
  return x < radius ? 2.0 * std::sqrt(radius * radius - x * x) : 0.0;
}

//! One slice of a beam at distance x from the middle of a hole.
struct Slice {
  double area = 0.0;
  double inertiaY = 0.0;
  double inertiaZ = 0.0;
  double torsion = 0.0;
  double ligament = 0.0;  // mean width of one of the two, where there is a hole
};

Slice sliceAt(double x, double width, double depth) {
  const double rims = std::min(2.0 * kRimDepth, depth / 2.0);
  const double core = depth - rims;
  const double hole = chord(kHoleRadius, x);
  const double rim = std::min(chord(kRimRadius, x), width - 0.5);
  Slice slice;
  slice.area = core * (width - hole) + rims * (width - rim);
  slice.inertiaZ = (core * (cube(width) - cube(hole)) + rims * (cube(width) - cube(rim))) / 12.0;
  slice.inertiaY =
      ((width - hole) * cube(core) + (width - rim) * (cube(depth) - cube(core))) / 12.0;
  slice.ligament = slice.area / (2.0 * depth);
  if (hole > 0.0) {
    const double arm = (width - slice.ligament) / 2.0;
    slice.torsion =
        2.0 * torsionOfRectangle(slice.ligament, depth) + kShearShare * slice.area * arm * arm;
  } else {
    slice.torsion = torsionOfRectangle(width, rim > 0.0 ? core : depth);
  }
  return slice;
}

}  // namespace

Section beamSection(double width, double depth) {
  Section mean;
  const double half = kMillimetresPerModule / 2.0;
  for (int i = 0; i < kSlices; ++i) {
    const Slice slice = sliceAt(half * (i + 0.5) / kSlices, width, depth);
    mean.area += 1.0 / slice.area;
    mean.inertiaY += 1.0 / slice.inertiaY;
    mean.inertiaZ += 1.0 / slice.inertiaZ;
    mean.torsion += 1.0 / slice.torsion;
  }
  Section section;
  section.area = kSlices / mean.area;
  section.inertiaY = kSlices / mean.inertiaY;
  section.inertiaZ = kSlices / mean.inertiaZ;
  section.torsion = kSlices / mean.torsion;
  section.shearZ = kShearShare * section.area;
  const Slice net = sliceAt(0.0, width, depth);
  const double panel = 0.45 * 2.0 * kHoleRadius;
  const double ligamentInertia = cube(net.ligament) * depth / 12.0;
  const double bending = kAbs.shearModulus() * cube(panel) /
                         (24.0 * kAbs.youngsModulus * ligamentInertia * kMillimetresPerModule);
  section.shearY = 1.0 / (1.0 / section.shearZ + bending);
  section.netArea = net.area;
  section.modulusY = net.inertiaY / (depth / 2.0);
  section.modulusZ = net.inertiaZ / (width / 2.0);
  section.modulusT = net.area * (width - net.ligament) / 2.0 / kPeak;
  section.netShear = net.area / kPeak;
  return section;
}

Section pinSection() {
  const double m = kPinInner / kPinOuter;
  const double nu = kAbs.poissonRatio;
  const double q = (1.0 + m * m) * (1.0 + m * m);
  const double share = 6.0 * (1.0 + nu) * q / ((7.0 + 6.0 * nu) * q + (20.0 + 12.0 * nu) * m * m);
  Section section;
  section.area = std::numbers::pi * (kPinOuter * kPinOuter - kPinInner * kPinInner);
  section.inertiaY =
      std::numbers::pi * (kPinOuter * cube(kPinOuter) - kPinInner * cube(kPinInner)) / 4.0;
  section.inertiaZ = section.inertiaY;
  section.torsion = 2.0 * section.inertiaY;
  section.shearY = share * section.area;
  section.shearZ = section.shearY;
  section.netArea = section.area;
  section.modulusY = section.inertiaY / kPinOuter;
  section.modulusZ = section.modulusY;
  section.modulusT = section.torsion / kPinOuter;
  // Greatest shear stress of a round tube: V Q / (I b) at its middle.
  const double firstMoment = 2.0 / 3.0 * (cube(kPinOuter) - cube(kPinInner));
  section.netShear = section.inertiaY * 2.0 * (kPinOuter - kPinInner) / firstMoment;
  return section;
}

Section axleSection() {
  const double w = kAxleWing;
  const double d = kAxleAcross;
  Section section;
  section.area = 2.0 * d * w - w * w;
  section.inertiaY = (w * cube(d) + (d - w) * cube(w)) / 12.0;
  section.inertiaZ = section.inertiaY;
  section.torsion = cube(w) * (2.0 * d - w) / 3.0;
  section.shearY = kShearShare * d * w;
  section.shearZ = section.shearY;
  section.netArea = section.area;
  section.modulusY = section.inertiaY / (d / 2.0);
  section.modulusZ = section.modulusY;
  section.modulusT = section.torsion / w;
  section.netShear = d * w / kPeak;
  return section;
}

Section rectangleSection(double width, double depth) {
  Section section;
  section.area = width * depth;
  section.inertiaY = width * cube(depth) / 12.0;
  section.inertiaZ = depth * cube(width) / 12.0;
  section.torsion = torsionOfRectangle(width, depth);
  section.shearY = kShearShare * section.area;
  section.shearZ = section.shearY;
  section.netArea = section.area;
  section.modulusY = section.inertiaY / (depth / 2.0);
  section.modulusZ = section.inertiaZ / (width / 2.0);
  section.modulusT = section.torsion / std::min(width, depth);
  section.netShear = section.area / kPeak;
  return section;
}

}  // namespace liftarm::analysis
