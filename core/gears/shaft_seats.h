#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gears/line_nodes.h"
#include "gears/shaft_plan.h"

namespace liftarm::gears {

//! \brief Keeps a shaft from sliding: what sits right before and right behind one of its bearings,
//! a gear or a bush, leaves it no way to go. The axle grows by a slot where it ends in that
//! bearing. \param others All shafts of the plan. \return False where there is no such bearing.
bool holdShaft(PlannedShaft& shaft,
               const std::vector<PlannedShaft>& others,
               const LineNodes& nodes);

//! \brief Puts a crank or a wheel at an end of a shaft, beyond its last bearing there.
//! \param side -1 or 1 along the axis. \return Why that cannot be; empty where it can.
std::string addEnd(PlannedShaft& shaft, int side, sketch::ShaftEnd what, const LineNodes& nodes);

//! \brief The number of the axle that has so many slots.
std::optional<std::string> axleOf(int slots);

//! \brief Turns the shafts so that teeth meet gaps. \param meshes As planned; no loops.
struct PlannedMesh {
  int a = 0;  //!< shaft
  int b = 0;
  int teethA = 0;
  int teethB = 0;
};

void setPhases(std::vector<PlannedShaft>& shafts, const std::vector<PlannedMesh>& meshes);

//! \brief Boxes of the cells that a shaft and its gears take.
std::vector<sketch::KeepOut> roomOf(const PlannedShaft& shaft);

//! \brief The cells that a disc takes in one slot: how far to either side in each row.
std::vector<int> rowsOf(double radius);

}  // namespace liftarm::gears
