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

//! \brief A male slot in a female slot: both coaxial, slot middles at the same point.
struct Connection {
  int male = -1;  //!< index of the part with the head
  int maleFeature = -1;
  int female = -1;  //!< index of the part with the hole
  int femaleFeature = -1;
  lattice::Vec3 at;  //!< middle of the slot, world
};

//! \brief The result: placed parts, and the text of the sketch they were made for (may be empty).
//! Connections are not stored: they are found from geometry (connections.h).
struct Model {
  std::string name;
  std::vector<PlacedPart> parts;
  std::string sketchJson;
};

}  // namespace liftarm::model
