#pragma once

#include <vector>

#include "analysis/scene.h"

namespace liftarm::analysis {

//! \brief A straight move: from `start` (off the part's place) along a unit direction, modules.
struct Path {
  lattice::Vec3 direction;
  double distance = 0.0;
  lattice::Vec3 start;
};

//! \brief Tells whether a part that is moved straight hits another part that stands still.
//! \details Bodies, heads and collars are swept exactly (convex.h). A head passes a hole that takes
//! it when both are coaxial and the move is along their axis; a collar may lie in the rim of a pin
//! hole, and passes none.
class Sweep {
 public:
  explicit Sweep(const Scene& scene);

  //! \brief Whether `fixed` is in the way of `mover`.
  [[nodiscard]] bool blocks(int mover, int fixed, const Path& path) const;

  //! \brief Whether two parts take the same space in their places: items 2 and 3 of DESIGN 5 tell.
  [[nodiscard]] bool overlapInPlace(int a, int b) const;

  //! \brief How far a part reaches along a unit vector, modules.
  struct Extent {
    double min = 1e9;
    double max = -1e9;
  };

  [[nodiscard]] Extent extent(int part, lattice::Vec3 along) const;

 private:
  struct Solid {
    Shape::Kind kind = Shape::Kind::kBody;
    parts::Prism prism;
    Box box;
    parts::FeatureKind head = parts::FeatureKind::kPin;  // heads only
    lattice::Vec3 wing;                                  // axle heads only
  };

  struct Hole {
    parts::FeatureKind kind = parts::FeatureKind::kPinHole;
    lattice::Vec3 center;
    lattice::Vec3 axis;
    double halfLength = 0.5;
    lattice::Vec3 wing;
  };

  struct Body {
    std::vector<Solid> solids;
    std::vector<Hole> holes;
    bool gear = false;
  };

  static Body makeBody(const model::PlacedPart& placed, const ScenePart& part);
  static bool hits(const Solid& mover, const Solid& fixed, const Path& path, double tolerance);
  static bool passesNot(const Solid& head, const Body& other, const Solid& wall, const Path& path);
  static bool solidsMeet(
      const Body& mover, const Solid& s, const Body& fixed, const Solid& t, const Path& path);

  std::vector<Body> bodies_;
};

}  // namespace liftarm::analysis
