#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/status.h"
#include "gears/train.h"
#include "lattice/vec.h"
#include "sketch/shaft.h"
#include "sketch/sketch.h"

namespace liftarm::gears {

//! \brief A part on an axle, in the slot at this coordinate along it.
struct Seat {
  int slot = 0;
  std::string part;     //!< LDraw number; empty: room for a part that does not sit on the axle
  int teeth = 0;        //!< of a gear
  double radius = 0.0;  //!< of what it sweeps
};

//! \brief The handle of a crank: a pin in the arm at a slot, that sticks out to one side.
struct CrankHandle {
  int slot = 0;
  int side = 1;
};

//! \brief An axle and what sits on it; all of it turns as one.
struct PlannedShaft {
  int axis = 0;
  Place at;       //!< on the two axes that follow `axis`, in turn
  int first = 0;  //!< slot, along the axis
  int last = 0;
  std::string axle;           //!< LDraw number
  std::vector<Seat> seats;    //!< by slot
  double phase = 0.0;         //!< radians that it is turned about its axis, so that teeth meet gaps
  std::vector<int> bearings;  //!< slots in which lines hold it
  std::vector<CrankHandle> handles = {};
};

//! \brief What the shafts and drives of a sketch are made of.
struct ShaftPlan {
  std::vector<PlannedShaft> shafts;  //!< the drawn ones first, in their order
  //! The sketch with its bearings as exact lines and room kept for all that turns.
  sketch::Sketch sketch;
};

//! \brief Plans gears, axles and bushes for what a sketch says of shafts (docs/shafts.md).
//! \return kInvalidInput with one sentence that names the place where that cannot be:
//! a shaft that runs in fewer than two lines, that meets a junction or another part, or that
//! nothing keeps from sliding; shafts that no gears couple with what bearings there are.
base::Result<ShaftPlan> planShafts(const sketch::Sketch& sketch, const sketch::Shafts& shafts);

//! \brief The cell of a slot of a shaft.
lattice::Cell cellOf(int axis, Place at, int slot);

}  // namespace liftarm::gears
