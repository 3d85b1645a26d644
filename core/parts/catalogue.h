#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lattice/vec.h"

namespace liftarm::parts {

enum class PartClass { kBeam, kPin, kAxle, kConnector, kBush, kGear };

//! \brief What a feature is: a male pin or axle, or a female pin or axle hole.
enum class FeatureKind { kPin, kAxle, kPinHole, kAxleHole };

constexpr bool isMale(FeatureKind kind) {
  return kind == FeatureKind::kPin || kind == FeatureKind::kAxle;
}

//! \brief A hole or a head: a straight stretch along an axis, in slots of one module (half for thin
//! beams).
struct Feature {
  FeatureKind kind = FeatureKind::kPinHole;
  lattice::Vec3 center;               //!< middle of the stretch, part frame, modules
  lattice::Vec3 axis;                 //!< unit vector along the stretch
  double length = 1.0;                //!< modules
  std::optional<lattice::Vec3> wing;  //!< direction of one wing of an axle's cross
  std::vector<lattice::Vec3> slots;   //!< slot middles, one module apart
};

//! \brief One stretch of a beam that covers sketch edges: from its first to its last hole centre.
struct Stretch {
  lattice::Vec3 from;
  lattice::Vec3 to;
};

//! \brief One cylinder-ended solid of the simplified shape: all points within `radius` (across) of
//! the segment, and within `halfThickness` along `axis`. Beams are one such prism per arm; a
//! connector's body is one per module; a head outside a hole is one per module too (axis = the
//! pin's axis).
struct Prism {
  lattice::Vec3 from;
  lattice::Vec3 to;
  lattice::Vec3 axis;
  double radius = 0.45;
  double halfThickness = 0.5;
};

//! \brief One real part. Part frame: LDraw's own, turned so that (x, y, z)ours = (x, z, -y)LDraw
//! / 20.
struct Part {
  std::string id;  //!< LDraw part number
  std::string name;
  PartClass partClass = PartClass::kConnector;
  double mass = 0.0;  //!< grams
  bool massEstimated = true;
  bool friction = false;   //!< a pin that holds by friction
  int color = 71;          //!< default LDraw colour
  int holes = 0;           //!< straight beams: number of holes; others 0
  double thickness = 1.0;  //!< beams: 1 or 0.5 modules
  std::vector<Feature> features;
  std::vector<Stretch> stretches;
  std::vector<Prism> solid;  //!< body only: the heads of `features` are not in it
  std::vector<Prism>
      collars;              //!< rings and necks of heads: sink into a pin hole's rim, else collide
  lattice::Vec3 boundsMin;  //!< of the LDraw geometry
  lattice::Vec3 boundsMax;
};

//! \brief All parts that may be used. Read once from the catalogue's data, then constant.
class Catalogue {
 public:
  //! \brief The built-in catalogue (core/parts/catalogue.json, embedded at build time).
  static const Catalogue& builtIn();

  [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }

  //! \return Null when there is no such part.
  [[nodiscard]] const Part* find(std::string_view id) const;

  explicit Catalogue(std::vector<Part> parts);

 private:
  std::vector<Part> parts_;
};

}  // namespace liftarm::parts
