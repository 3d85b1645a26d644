#pragma once

#include "gears/train.h"

namespace liftarm::gears {

//! Radius of an axle, modules.
inline constexpr double kAxleRadius = 0.3;

//! \brief Whether two discs keep apart, with a little room to spare.
bool keepApart(const Disc& p, const Disc& q);

//! \brief Tells whether a train has room: gears that are not meant to mesh keep apart from each
//! other, from all axles and from what is there already.
class TrainRoom {
 public:
  //! \pre The request outlives this.
  explicit TrainRoom(const TrainRequest& request) : request_(request) {}

  [[nodiscard]] bool holds(const Train& train) const;

 private:
  [[nodiscard]] bool hasRoom(const Train& train, const TrainGear& gear) const;

  const TrainRequest& request_;
};

//! \brief A gear of a train as what it sweeps.
Disc discOf(const Train& train, const TrainGear& gear);

}  // namespace liftarm::gears
