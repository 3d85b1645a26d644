#pragma once

#include <array>
#include <vector>

#include "linkages/plane.h"

namespace liftarm::linkages {

//! Points at equal arc length that stand for a closed curve.
inline constexpr int kShapePoints = 32;
//! Fourier coefficients of orders 1, -1, 2, -2 and so on.
inline constexpr int kOrders = 4;
inline constexpr int kCoefficients = 2 * kOrders;

using ShapePoints = std::array<Point, kShapePoints>;
using Coefficients = std::array<Point, kCoefficients>;

//! \brief Length of a polyline; a closed one goes back to its first point.
double lengthOf(const std::vector<Point>& line, bool closed);

//! \brief Points at equal arc length along a polyline. An open one keeps both ends, a closed one
//! has its first point once.
//! \pre length is positive; count >= 2.
std::vector<Point> resample(const std::vector<Point>& line, bool closed, int count);

//! \brief Complex Fourier coefficients of a closed curve over its arc length \cite
//! zahn_1972_fourier: z(s) = sum c_k exp(2 pi i k s). A turn multiplies all by one unit number,
//! another start c_k by the k-th power of one, a shift changes c_0 alone, which is left out.
Coefficients coefficientsOf(const ShapePoints& points);

//! \brief Magnitudes: what neither place, turn nor start changes. For each order the larger of the
//! two directions of the leading pair comes first, so that way round and mirror do not count.
std::array<float, kCoefficients> sizesOf(const Coefficients& coefficients);

//! \brief exp(2 pi i k / kShapePoints).
const ShapePoints& rootsOfUnity();

}  // namespace liftarm::linkages
