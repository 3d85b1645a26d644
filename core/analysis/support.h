#pragma once

#include <vector>

#include "analysis/scene.h"

namespace liftarm::analysis {

//! \brief A place on the ground plane, modules.
struct GroundPoint {
  double x = 0.0;
  double y = 0.0;
};

//! What lies within this height above the lowest point touches the ground, modules: 0.4 mm, which
//! the play of pins gives.
inline constexpr double kTouch = 0.05;

//! \brief The height of the lowest point of some parts. \pre There is one with a shape.
double lowestPoint(const Scene& scene, const std::vector<int>& parts);

//! \brief The corners of all faces and edges of some parts that touch the ground at a height.
std::vector<GroundPoint> touchingPoints(const Scene& scene,
                                        const std::vector<int>& parts,
                                        double ground);

//! \brief The convex hull of points, counter-clockwise, without points on its sides; one or two
//! points where all lie on a point or a line.
std::vector<GroundPoint> convexHull(std::vector<GroundPoint> points);

}  // namespace liftarm::analysis
