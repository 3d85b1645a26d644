#pragma once

namespace liftarm::analysis {

//! \brief What a frame element needs to know of its cross-section. Local x runs along the element,
//! z along the holes of a beam, y across both. mm. \details The first six describe the stiffness of
//! the equal prismatic bar, the others the strength of the weakest cross-section.
struct Section {
  double area = 0.0;      //!< mm^2
  double inertiaY = 0.0;  //!< mm^4, bending about y
  double inertiaZ = 0.0;  //!< mm^4, bending about z
  double torsion = 0.0;   //!< mm^4
  double shearY = 0.0;    //!< mm^2, shear area for forces along y
  double shearZ = 0.0;    //!< mm^2, for forces along z
  double netArea = 0.0;   //!< mm^2
  double modulusY = 0.0;  //!< mm^3: bending stress = moment / modulus
  double modulusZ = 0.0;
  double modulusT = 0.0;  //!< mm^3: greatest shear stress = torque / modulus
  double netShear = 0.0;  //!< mm^2: greatest shear stress = force / netShear
};

//! \name Dimensions, mm. From LDraw's geometry (20 LDU = 8 mm).
//! @{
inline constexpr double kHoleRadius = 2.4;  //!< of a pin hole
inline constexpr double kRimRadius = 3.2;   //!< of the wider rim at both ends of a hole
inline constexpr double kRimDepth = 0.8;    //!< of each rim
inline constexpr double kPinOuter = 2.4;    //!< radius
inline constexpr double kPinInner = 1.6;    //!< radius of the bore
inline constexpr double kAxleAcross = 4.8;  //!< over the wings
inline constexpr double kAxleWing = 1.8;    //!< thickness of a wing
inline constexpr double kBeamWidth = 7.2;   //!< 18 LDU
inline constexpr double kBeamDepth = 8.0;   //!< along the holes
//! @}

//! \brief A beam with a hole at each module.
//! \details Slices across the beam, each a pair of ligaments beside the chord of the hole and its
//! rims, are in series: 1/A = mean of 1/A(x) over one module, likewise the second moments, the
//! torsion constant and the shear areas (5/6 of the slice). Across a hole the ligaments twist as
//! two rectangles and as a couple of shear forces, and in the plane of the beam they bend between
//! the ends of the hole as in a Vierendeel panel of 0.45 diameters (the equivalent length of a
//! round opening in castellated beams), which adds a^3 / (24 E I) per hole to the shear compliance.
//! No stress concentration. ESTIMATE to about 10 %: the recesses between holes are left out. \param
//! width  Across the holes' axis, mm. \param depth Along the holes' axis, mm.
Section beamSection(double width, double depth);

//! \brief A hollow pin: a tube; shear area after Cowper. Its slots are left out.
Section pinSection();

//! \brief A cross of two flat bars.
Section axleSection();

//! \brief A solid rectangle; for tests against closed forms. \param width Along y. \param depth
//! Along z.
Section rectangleSection(double width, double depth);

}  // namespace liftarm::analysis
