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

}  // namespace liftarm::instructions
