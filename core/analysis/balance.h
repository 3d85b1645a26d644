#pragma once

#include <optional>
#include <vector>

#include "analysis/scene.h"
#include "analysis/support.h"

namespace liftarm::analysis {

//! \brief Whether a model stands by itself on a level floor.
struct Balance {
  bool stable = false;
  lattice::Vec3 centre;              //!< of mass, world, modules
  double mass = 0.0;                 //!< grams
  double ground = 0.0;               //!< height of the floor: the lowest point of the model
  std::vector<GroundPoint> polygon;  //!< what it stands on, convex, counter-clockwise
  double margin = 0.0;        //!< modules from the centre to the nearest side; negative: outside
  double tippingAngle = 0.0;  //!< degrees of slope that it bears; 0 when unstable
  GroundPoint direction;      //!< unit, the way in which it falls most easily
};

//! \brief The centre of mass of a part in its own frame, modules. \details Beams: the mean of their
//! holes, about which the material lies evenly. Others: the mean of their bodies and heads by
//! volume.
lattice::Vec3 centreOfMass(const parts::Part& part);

//! \brief Balance of some parts that move as one.
//! \details The floor is level at the height of their lowest point. \return Nothing where none of
//! the parts is known.
std::optional<Balance> balanceOf(const Scene& scene, const std::vector<int>& parts);

//! \brief Balance of a model: of the assembly that stands worst, where it has several. Parts that
//! nothing holds are left out.
std::optional<Balance> checkBalance(const Scene& scene);

}  // namespace liftarm::analysis
