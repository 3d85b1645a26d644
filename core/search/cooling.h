#pragma once

#include <cstdint>
#include <functional>
#include <memory>

namespace liftarm::search {

//! \brief What a cooling schedule is told of one move.
struct CooledMove {
  double temperature = 0.0;  //!< at which the move was judged
  double energy = 0.0;       //!< of the layout after it, whether it was kept or not
  double change = 0.0;       //!< of the objective; 0 where the move was not kept
};

//! \brief Where a schedule begins and ends. \details All schedules of one search are given the same
//! number of moves, that of the exponential one, so that they can be compared.
struct CoolingPlan {
  double start = 2000.0;
  double end = 1e-4;
  std::uint64_t moves = 1;
};

//! \brief A cooling schedule other than the exponential one: told every move, in order.
class Cooling {
 public:
  virtual ~Cooling() = default;

  //! \return The temperature of the next move, above 0.
  virtual double next(const CooledMove& move) = 0;
};

using MakeCooling = std::function<std::unique_ptr<Cooling>(const CoolingPlan&)>;

}  // namespace liftarm::search
