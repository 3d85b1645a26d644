#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/scene.h"
#include "sketch/shaft.h"

namespace liftarm::analysis {

//! \brief An axle and what is fixed to it: all of it turns as one. It carries a gear, or the sketch
//! draws it.
struct GearShaft {
  std::vector<int> parts;                   //!< ascending
  std::optional<int> drawn = std::nullopt;  //!< the shaft of the sketch that it is
  lattice::Vec3 at;                         //!< a point of its axis, world, modules
  lattice::Vec3 axis;                       //!< unit
  int bearings = 0;                         //!< round holes that it runs in
  bool turns = false;  //!< it is joined to the rest by heads in round holes on its axis alone
  bool held = false;   //!< one of these holes cannot slide along it
  int train = 0;       //!< shafts of one train turn together
  //! Turns for one turn of the first shaft of its train, about its own axis.
  double speed = 1.0;
};

//! \brief Two gears whose pitch circles touch.
struct GearMesh {
  int a = -1;  //!< part
  int b = -1;
  int shaftA = -1;
  int shaftB = -1;
  double ratio = 1.0;  //!< turns of b for one of a, each about the axis of its shaft
};

//! \brief All that gears couple in a model.
struct GearTrains {
  std::vector<GearShaft> shafts;  //!< by their first part
  std::vector<GearMesh> meshes;
  std::vector<int> binding;  //!< meshes that ask for another speed than those before
  //! Gears of two shafts that are too near to pass each other and do not mesh.
  std::vector<std::pair<int, int>> clashes;
  int trains = 0;
};

//! Pitch circles touch within this, modules.
inline constexpr double kPitchTolerance = 0.02;

//! \brief The axle that lies along a drawn shaft from end to end.
std::optional<int> axleAlong(const Scene& scene, const sketch::Shaft& shaft);

//! \brief Finds shafts, meshes and speeds from geometry alone: teeth by the catalogue, a pitch
//! radius of teeth / 16 modules (docs/shafts.md). Gears on parallel shafts mesh; those of other
//! shapes are not known yet.
GearTrains findGearTrains(const Scene& scene);

//! \brief Why the shafts of a train cannot turn, as one sentence for a person; empty where they
//! can.
std::string whyTrainIsStiff(const GearTrains& trains, int train);

//! \brief Where a shaft is when it has turned by an angle, radians: start place -> present place.
lattice::Pose turned(const GearShaft& shaft, double angle);

}  // namespace liftarm::analysis
