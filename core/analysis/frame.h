#pragma once

#include <array>
#include <vector>

#include "analysis/materials.h"
#include "analysis/sections.h"
#include "lattice/vec.h"

namespace liftarm::analysis {

//! \brief Displacement or load of a node: three of translation (mm or N), three of rotation (rad or
//! N mm), world axes.
using Six = std::array<double, 6>;

//! \brief A straight Timoshenko bar between two nodes.
struct FrameElement {
  int a = -1;
  int b = -1;
  lattice::Vec3 up;    //!< local z as far as it is across the bar (the hole axis of a beam)
  int section = 0;     //!< index into Frame::sections
  int part = -1;       //!< for reports
  bool head = false;   //!< stretch of a pin or axle: its shear is reported
  lattice::Vec3 load;  //!< spread evenly along the bar, N/mm, world axes
};

//! \brief Springs between two nodes, or between a node and the ground, in one point that both carry
//! along as if rigid.
struct FrameSpring {
  int a = -1;
  int b = -1;          //!< -1: the ground
  lattice::Vec3 at;    //!< mm
  lattice::Mat3 axes;  //!< columns: the spring's own axes
  Six stiffness{};     //!< N/mm along, N mm/rad about these axes
};

//! \brief A frame of bars, springs and loads. N, mm, MPa.
struct Frame {
  std::vector<lattice::Vec3> nodes;  //!< mm
  std::vector<FrameElement> elements;
  std::vector<FrameSpring> springs;   //!< always in place
  std::vector<FrameSpring> contacts;  //!< to the ground, each can be switched off
  std::vector<Section> sections;
  std::vector<Six> loads;  //!< per node, without those spread along bars
  Material material = kAbs;
};

//! \brief A bar's own axes: columns x (along), y, z.
lattice::Mat3 axesOf(const Frame& frame, const FrameElement& element);

double lengthOf(const Frame& frame, const FrameElement& element);

//! \brief Stiffness of a bar in its own axes: 12 x 12 by rows, both ends' six displacements.
//! \details Przemieniecki's element with shear flexibility, \cite przemieniecki_1968_matrix 5.6.
std::array<double, 144> stiffnessOf(const Frame& frame, const FrameElement& element);

//! \brief What a bar's ends feel when they are held and the bar carries its spread load: the equal
//! nodal loads, world axes, end a then b.
std::array<double, 12> equalNodalLoads(const Frame& frame, const FrameElement& element);

//! \brief All loads of the frame on its nodes, world axes.
std::vector<Six> nodalLoads(const Frame& frame);

//! \brief Forces in a bar at one place along it, in its own axes.
struct SectionForces {
  double normal = 0.0;   //!< N, tension positive
  double shearY = 0.0;   //!< N
  double shearZ = 0.0;   //!< N
  double torque = 0.0;   //!< N mm
  double momentY = 0.0;  //!< N mm
  double momentZ = 0.0;  //!< N mm
};

//! \param share 0 at end a, 1 at end b.
SectionForces forcesAt(const Frame& frame,
                       const FrameElement& element,
                       const std::vector<Six>& displacements,
                       double share);

//! \brief Greatest von Mises stress over the cross-section, MPa: normal, bending, torsion and shear
//! taken at their worst together.
double vonMises(const Section& section, const SectionForces& forces);

//! \brief Displacement in the middle of a bar, mm (cubic between the ends).
lattice::Vec3 middleDisplacement(const Frame& frame,
                                 const FrameElement& element,
                                 const std::vector<Six>& displacements);

//! \brief What a spring does to its node a, N and N mm about the spring's own point, spring axes.
Six springForces(const Frame& frame,
                 const FrameSpring& spring,
                 const std::vector<Six>& displacements);

//! \brief The relative displacement that a spring feels, as 6 rows over a's and b's twelve
//! displacements.
std::array<std::array<double, 12>, 6> springRows(const Frame& frame, const FrameSpring& spring);

}  // namespace liftarm::analysis
