#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/box.h"
#include "model/connections.h"
#include "model/model.h"
#include "sketch/sketch.h"

namespace liftarm::analysis {

//! Pins and axles have a radius of 6 LDU; pins flare to 6.25 at their tips. Modules.
inline constexpr double kHeadRadius = 0.3;
//! Tips of gear teeth reach this far beyond the pitch circle (addendum and clearance), modules.
inline constexpr double kToothHeight = 0.125;
//! The depth of the rim of a pin hole, modules.
inline constexpr double kCounterbore = 0.1;

//! \brief One convex piece of a placed part, in the world.
struct Shape {
  enum class Kind { kBody, kHead, kCollar };

  Kind kind = Kind::kBody;
  parts::Prism prism;
  int feature = -1;  //!< heads: which male slot this is
  int slot = -1;
};

//! \brief A placed part with everything that the checks look at.
struct ScenePart {
  const parts::Part* part = nullptr;  //!< null: not in the catalogue; then nothing else is filled
  std::vector<Shape> shapes;
  Box box;
};

//! \brief A model made ready for the checks. Refers to the model and the catalogue it was made
//! from.
struct Scene {
  const model::Model* model = nullptr;
  std::vector<ScenePart> parts;
  std::vector<model::Connection> connections;  //!< good and bad ones
  std::optional<sketch::Sketch> sketch;        //!< nothing where the model has none
  std::string sketchError;                     //!< why the model's sketch cannot be read
};

Scene makeScene(const model::Model& model, const parts::Catalogue& catalogue);

//! \brief A part's name for messages: number, index and title.
std::string nameOf(const Scene& scene, int part);

//! \brief A point for messages: "(1, 2.5, 0)".
std::string pointText(lattice::Vec3 p);

}  // namespace liftarm::analysis
