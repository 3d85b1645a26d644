#pragma once

#include <cstddef>
#include <cstdlib>
#include <vector>

#include "lattice/vec.h"

namespace liftarm::sketch {

//! \brief What sits at an end of a shaft.
enum class ShaftEnd { kNothing, kCrank, kWheel };

//! \brief An axle that turns in the holes of the lines that it crosses. Each node from its first to
//! its last is a slot of one module.
struct Shaft {
  lattice::Cell from;
  lattice::Cell to;
  ShaftEnd atFrom = ShaftEnd::kNothing;
  ShaftEnd atTo = ShaftEnd::kNothing;

  //! \brief The axis that it lies along.
  [[nodiscard]] int axis() const { return from.x != to.x ? 0 : (from.y != to.y ? 1 : 2); }

  [[nodiscard]] int slots() const { return std::abs(to[axis()] - from[axis()]) + 1; }
};

//! \brief Two shafts that gears couple.
struct Drive {
  int from = 0;            //!< the shaft that drives
  int to = 1;              //!< the one that is driven
  double ratio = 1.0;      //!< turns of the first for one turn of the second
  double tolerance = 3.0;  //!< per cent that the ratio may be off
};

//! \brief What turns in a sketch (docs/shafts.md). The lines know nothing of it.
struct Shafts {
  std::vector<Shaft> shafts;
  std::vector<Drive> drives;

  [[nodiscard]] bool empty() const { return shafts.empty(); }
};

inline constexpr std::size_t kMaxShafts = 100;
inline constexpr std::size_t kMaxDrives = 100;
inline constexpr int kMaxShaftSlots = 12;  //!< of the longest axle
inline constexpr double kMaxRatio = 1000.0;
inline constexpr double kMaxRatioTolerance = 50.0;  //!< per cent

}  // namespace liftarm::sketch
