#pragma once

#include <optional>
#include <vector>

#include "linkages/plane.h"

namespace liftarm::linkages {

//! \brief How a linkage's plane lies on that of a drawn path: p -> turn * (mirrored ? conjugate(p)
//! : p) + shift. Size is kept: holes are a module apart.
struct Placement {
  Point turn{1.0, 0.0};  //!< unit
  bool mirrored = false;
  Point shift;

  [[nodiscard]] Point apply(Point p) const { return turn * (mirrored ? conjugate(p) : p) + shift; }
};

//! \brief By which turns a linkage may be placed.
enum class Turns {
  kAny,
  kQuarter,  //!< pivots beside or above each other
};

//! \brief A drawn path, ready to be compared.
struct DrawnPath {
  std::vector<Point> points;  //!< at equal arc length
  bool closed = true;
};

//! \brief A curve laid on a path, and how far they are apart.
struct Match {
  Placement placement;
  double error = 0.0;    //!< mean distance, modules; of a closed path both ways
  double largest = 0.0;  //!< the largest of those
};

//! \brief The turn and shift that bring points nearest to others, point by point, in the sense of
//! least squares (in the plane in closed form: the turn is the angle of a complex sum).
//! \param start Its mirror is kept, and its turn where only quarters are allowed.
Placement fitted(const std::vector<Point>& points,
                 const std::vector<Point>& onto,
                 const Placement& start,
                 Turns turns);

//! \brief The sum of squared distances that `fitted` leaves, per point, mirrored as told; quarters
//! tried in turn.
std::pair<Placement, double> bestFit(const std::vector<Point>& points,
                                     const std::vector<Point>& onto,
                                     bool mirrored,
                                     Turns turns);

//! \brief Improves a placement by pairing nearest points again and again \cite besl_1992_method,
//! and measures it.
//! \param curve Closed. Of an open path, only that it lies on the curve counts.
Match refine(const DrawnPath& path,
             const std::vector<Point>& curve,
             const Placement& start,
             Turns turns);

}  // namespace liftarm::linkages
