#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace liftarm::sketch {

//! \brief Wanted: the two points are `length` apart. Entries are variables, one for each
//! coordinate.
struct LengthRow {
  std::array<int, 3> from{};
  std::array<int, 3> to{};
  double length = 0.0;
};

//! \brief Wanted: the sum of coefficient times variable is zero.
struct LinearRow {
  std::vector<std::pair<int, double>> terms;
};

//! \brief Coordinates and what must hold between them, in modules.
struct SnapSystem {
  std::vector<double> values;
  std::vector<char> held;  //!< for each value: not zero when it must not move
  std::vector<LengthRow> lengths;
  std::vector<LinearRow> linear;
  std::int64_t workLeft = 800'000'000;  //!< terms that may still be multiplied: bounds the time
};

//! \brief How far a row is from what is wanted, with its sign.
double residualOf(const SnapSystem& system, const LengthRow& row);
double residualOf(const SnapSystem& system, const LinearRow& row);

//! \brief The largest magnitude among the length rows.
double largestLengthResidual(const SnapSystem& system);

//! \brief The largest magnitude among the linear rows.
double largestLinearResidual(const SnapSystem& system);

//! \brief Moves the free values as little as possible (Gauss-Newton, least-norm steps) until every
//! row holds to about 1e-11, or keeps the best that was found where the rows contradict each other.
//! \details Only + - * / and square roots, in a fixed order: the same bits on every platform. Steps
//! are solved by conjugate gradients on J J^T with a slight damping, which also copes with rows
//! that say the same thing twice.
void solveSnapSystem(SnapSystem& system);

}  // namespace liftarm::sketch
