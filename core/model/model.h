#pragma once

#include <string>
#include <vector>

#include "lattice/vec.h"
#include "parts/catalogue.h"

namespace liftarm::model {

//! \brief One real part in its place. What it covers is for pictures and reports; nothing is judged
//! by it.
struct PlacedPart {
  std::string part;    //!< catalogue id
  int color = 71;      //!< LDraw colour
  lattice::Pose pose;  //!< part frame -> world, modules
  int component = -1;  //!< beams: index of the coplanar component, else -1
  int layer = 0;       //!< beams: offset along the hole axis
  int piece = 0;       //!< connected part of the sketch
};

//! \brief How a male and a female slot that share their place go together.
enum class Fit {
  kTurn,       //!< pin in pin hole, or axle between stops: held, turns
  kSlide,      //!< axle in pin hole: turns and slides, holds nothing along its axis
  kRigid,      //!< axle in axle hole
  kTwisted,    //!< axle in axle hole with its cross turned: does not go in
  kWrongKind,  //!< pin in axle hole: never goes in
  kMisplaced   //!< coaxial, but not slot in slot
};

constexpr bool isGood(Fit fit) {
  return fit == Fit::kTurn || fit == Fit::kSlide || fit == Fit::kRigid;
}

//! \brief A male slot in a female slot: both coaxial, slot middles at the same point (half-module
//! holes: inside the male slot).
struct Connection {
  int male = -1;  //!< index of the part with the head
  int maleFeature = -1;
  int maleSlot = -1;
  int female = -1;  //!< index of the part with the hole
  int femaleFeature = -1;
  int femaleSlot = -1;
  Fit fit = Fit::kTurn;
  lattice::Vec3 at;  //!< middle of the female slot, world
};

//! \brief The result: placed parts, and the text of the sketch they were made for (may be empty).
//! Connections are not stored: they are found from geometry (connections.h).
struct Model {
  std::string name;
  std::vector<PlacedPart> parts;
  std::string sketchJson;
};

}  // namespace liftarm::model
