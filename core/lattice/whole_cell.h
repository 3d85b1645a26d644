#pragma once

#include <cmath>
#include <optional>

#include "lattice/vec.h"

namespace liftarm::lattice {

//! \brief The cell whose middle is this point, if there is one within the tolerance on every axis.
//! \param tolerance Modules, below 0.5.
inline std::optional<Cell> wholeCell(Vec3 p, double tolerance) {
  Cell cell;
  for (int i = 0; i < 3; ++i) {
    cell[i] = static_cast<int>(std::floor(p[i] + 0.5));
    if (std::abs(p[i] - static_cast<double>(cell[i])) > tolerance) {
      return std::nullopt;
    }
  }
  return cell;
}

}  // namespace liftarm::lattice
