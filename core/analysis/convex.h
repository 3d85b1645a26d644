#pragma once

#include "analysis/box.h"
#include "parts/catalogue.h"

namespace liftarm::analysis {

//! \brief Whether two stadium prisms in any orientation interpenetrate.
//! \details Both are drawn in by half the tolerance on every side and then tested exactly: the
//! origin in their Minkowski difference, by the method of \cite gilbert_1988_distance on support
//! points. Only
//! + - * / and square roots, so the answer is the same on every platform.
//! \param tolerance Modules by which the two may enter each other.
//! \pre Unit axes; |to - from| is across the axis.
bool overlap(const parts::Prism& a, const parts::Prism& b, double tolerance);

//! \brief The same for all that the first prism passes on a straight move by `travel` (modules).
bool overlapOnTheWay(const parts::Prism& a,
                     lattice::Vec3 travel,
                     const parts::Prism& b,
                     double tolerance);

//! \brief The same for a prism and an axis-aligned box.
bool overlap(const parts::Prism& a, const Box& box, double tolerance);

//! \brief The smallest axis-aligned box around a prism.
Box boundsOf(const parts::Prism& prism);

}  // namespace liftarm::analysis
