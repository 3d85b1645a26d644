#pragma once

#include "lattice/vec.h"

namespace liftarm::analysis {

//! \brief A linear-elastic, isotropic material. N, mm, MPa.
struct Material {
  double youngsModulus = 0.0;  //!< MPa
  double poissonRatio = 0.0;
  double yieldStress = 0.0;  //!< MPa, in tension

  [[nodiscard]] constexpr double shearModulus() const {
    return youngsModulus / (2.0 * (1.0 + poissonRatio));
  }

  //! \brief Yield in pure shear after von Mises: yield / sqrt(3).
  [[nodiscard]] constexpr double shearYield() const { return yieldStress * kInverseRootThree; }

 private:
  static constexpr double kInverseRootThree = 0.57735026918962576;
};

//! \brief ABS: E 2.2 to 2.3 GPa, Poisson's ratio 0.35, yield about 40 MPa (../shared/README.md).
//! Pins and axles are of denser POM or PA, for which no measurement is at hand: they are reckoned
//! as ABS too, an estimate.
inline constexpr Material kAbs{2250.0, 0.35, 40.0};

using lattice::kMillimetresPerModule;
inline constexpr double kGravity = 9.80665;  //!< m/s^2

//! \name Stiffness of a head in a hole
//! The hole is a bed of springs along the head: E per mm of length and mm of displacement (contact
//! of a cylinder in a line of its own width). ESTIMATE: no measurement found.
//! @{
constexpr double fitStiffness(double length) {  //!< N/mm across the axis
  return kAbs.youngsModulus * length;
}

constexpr double fitRockingStiffness(double length) {  //!< N mm / rad, about an axis across
  return fitStiffness(length) * length * length / 12.0;
}

//! @}

//! \brief Turning stiffness of a pin that friction holds, N mm / rad. ASSUMPTION: no measurement of
//! pin friction was found; it is an option of every analysis.
inline constexpr double kHeldStiffness = 1000.0;

//! \brief Stiffness of the ground under one point of contact, N/mm. ESTIMATE: one module of ABS.
inline constexpr double kGroundStiffness = kAbs.youngsModulus * kMillimetresPerModule;

}  // namespace liftarm::analysis
