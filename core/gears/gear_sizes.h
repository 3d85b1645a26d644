#pragma once

#include <string>
#include <vector>

#include "parts/catalogue.h"

namespace liftarm::gears {

//! Technic gears are of module 1 mm: the pitch radius is teeth / 2 mm, in modules of 8 mm:
inline constexpr double kTeethPerModule = 16.0;

//! Tips of teeth reach at most this far beyond the pitch circle, modules.
inline constexpr double kAddendum = 0.125;

//! \brief A gear that can sit on an axle and fills one slot of it.
struct GearSize {
  int teeth = 0;
  std::string part;  //!< LDraw number
};

//! \brief The gears among some parts, one for each number of teeth, by teeth: those with an axle
//! hole of one module in their middle. Of two with as many teeth the first one is taken.
std::vector<GearSize> gearSizesOf(const std::vector<parts::Part>& parts);

//! \brief Whether two gears on parallel shafts mesh at a whole number of modules.
constexpr bool meshOnLattice(int teethA, int teethB) {
  return (teethA + teethB) % static_cast<int>(kTeethPerModule) == 0;
}

//! \brief Distance of two parallel shafts whose gears mesh. \pre meshOnLattice().
constexpr int meshDistance(int teethA, int teethB) {
  return (teethA + teethB) / static_cast<int>(kTeethPerModule);
}

//! \brief Radius of what a gear sweeps, modules.
constexpr double tipRadius(int teeth) {
  return static_cast<double>(teeth) / kTeethPerModule + kAddendum;
}

}  // namespace liftarm::gears
