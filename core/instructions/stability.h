#pragma once

#include <vector>

#include "analysis/scene.h"

namespace liftarm::instructions {

//! Parts touch the table within this, modules: rounded edges and play.
inline constexpr double kTouch = 0.06;

//! \brief Whether connected parts stand on a table by themselves, by their weight alone.
//! \details Their centre of mass (part masses at the middles of their bounds) lies over the convex
//! hull of what touches the table, a tenth of a module inside.
//! \param up   Unit vector; the table is where the parts reach furthest against it.
//! \param lean What is so high above the table, modules, counts as touching: they may tilt a
//! little.
bool standsOn(const analysis::Scene& scene,
              const std::vector<int>& parts,
              lattice::Vec3 up,
              double lean = kTouch);

//! \brief The same for parts that may be several connected sets: each stands by itself, and all
//! reach the same table.
bool standTogether(const analysis::Scene& scene,
                   const std::vector<std::vector<int>>& sets,
                   lattice::Vec3 up,
                   double lean = kTouch);

//! \brief Whether they stand as they are, or lie on one of their other five sides, leaning by a
//! module at most.
bool standAnyway(const analysis::Scene& scene, const std::vector<std::vector<int>>& sets);

//! \brief Whether connected parts that are built apart lie on some side: one of the model's six, or
//! a side of one of their own beams, which may be at a slant.
bool canBeLaidDown(const analysis::Scene& scene, const std::vector<int>& parts);

//! \brief Tells quickly of many sets of connected parts whether they stand as they are.
class Footing {
 public:
  explicit Footing(const analysis::Scene& scene);

  [[nodiscard]] bool stands(const std::vector<int>& parts) const;

 private:
  struct Foot {
    double floor = 1e9;                 // the lowest point of the part
    std::vector<lattice::Vec3> points;  // what it would touch a table there with
    lattice::Vec3 moment;               // g times modules
    double mass = 0.0;
  };

  std::vector<Foot> feet_;
};

}  // namespace liftarm::instructions
