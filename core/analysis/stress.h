#pragma once

#include <string>
#include <vector>

#include "analysis/frame_model.h"

namespace liftarm::analysis {

//! \brief A model's frame under its loads: at rest, or on the move.
struct StressState {
  bool stands = false;      //!< false: something moves without resistance
  std::string message;      //!< why not, and what would help
  std::vector<int> moving;  //!< the parts that move then
  FrameModel model;
  std::vector<bool> touching;      //!< contacts that carry
  std::vector<Six> displacements;  //!< per node, mm and rad; a free motion where it does not stand
};

//! \brief Solves a model's frame under its weight and loads on a ground that pushes but does not
//! pull.
//! \details Contacts are let go where they would pull and put back where they would sink in, until
//! none changes. A frame that can move without resistance is not solved: the state says which parts
//! move, whether it folds (a mechanism) or tips over.
//! \return The state, or why there is no frame (makeFrameModel()).
base::Result<StressState> solveStress(const Scene& scene, const StressOptions& options);

//! \brief Stress and displacement at one place along a part.
struct StressSample {
  lattice::Vec3 at;            //!< world, modules, at rest
  double stress = 0.0;         //!< von Mises, MPa
  lattice::Vec3 displacement;  //!< mm
};

struct PartStress {
  double stress = 0.0;                //!< greatest von Mises stress, MPa
  double safety = 0.0;                //!< yield stress over it, at most kMaxSafety
  double utilisation = 0.0;           //!< it over the yield stress
  std::vector<StressSample> samples;  //!< three along each bar; one where the part has none
};

//! \brief A part with heads: pins, axles, connectors with pins.
struct PinStress {
  int part = -1;
  double shear = 0.0;   //!< greatest shear stress across its heads, MPa
  double safety = 0.0;  //!< shear yield over it, at most kMaxSafety
  double torque = 0.0;  //!< greatest torque that friction must hold in one of its holes, N mm
};

//! \brief What the ground does to the model in one point.
struct Reaction {
  lattice::Vec3 at;     //!< world, modules
  lattice::Vec3 force;  //!< N
};

struct StressReport {
  double maxStress = 0.0;        //!< MPa
  double safety = 0.0;           //!< least of beams and pins
  double maxDisplacement = 0.0;  //!< mm
  double weight = 0.0;           //!< N
  double imbalance =
      0.0;  //!< sum of loads and reactions over the greatest of them; 0 but for rounding
  lattice::Vec3 up{0, 0, 1};  //!< away from the table it rests on
  double tilt = 0.0;          //!< degrees between that and the drawing's z
  std::vector<PartStress> parts;
  std::vector<PinStress> pins;
  std::vector<Reaction> reactions;
};

inline constexpr double kMaxSafety = 1e6;

//! \pre state.stands.
StressReport reportStress(const Scene& scene, const StressState& state);

}  // namespace liftarm::analysis
