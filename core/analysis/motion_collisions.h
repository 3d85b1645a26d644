#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/scene.h"

namespace liftarm::analysis {

//! \brief By how much two parts may enter each other while they move, modules: each drawn in by 0.6
//! LDU (0.24 mm). What touches no deeper slips past: pins have that play, and solids taken from
//! LDraw's geometry and drawn in as much show no contact there.
inline constexpr double kGrazing = 0.06;

//! \brief Looks for parts that run into each other while bodies move.
//! \details Convex pieces that enter each other at the start are let off for good: heads in holes,
//! collars in rims, gears in mesh.
class MotionCollisions {
 public:
  //! \param bodyOf The body of each part; parts of one body are not tested against each other.
  MotionCollisions(const Scene& scene, const std::vector<int>& bodyOf);

  //! \brief Two parts that share space. \param poses Start -> present place, per body.
  std::optional<std::pair<int, int>> find(const std::vector<lattice::Pose>& poses);

 private:
  struct Piece {
    int part = -1;
    int body = -1;
    parts::Prism start;
  };

  bool letOff(std::size_t i, std::size_t j);

  std::vector<Piece> pieces_;
  std::map<std::pair<std::size_t, std::size_t>, bool> enteredAtStart_;
};

}  // namespace liftarm::analysis
