#pragma once

#include <vector>

#include "cli/solve_command.h"

namespace liftarm::cli {

//! \brief Options of `liftarm train`, as given.
struct TrainOptions {
  std::vector<int> way;    //!< from the first shaft to the last, modules: two numbers
  double ratio = 1.0;      //!< turns of the first shaft for one turn of the last
  double tolerance = 3.0;  //!< per cent of the ratio
  bool json = false;
};

//! \brief Finds the gears that couple two parallel shafts (gears/train.h) and prints them, shaft by
//! shaft. \return kNotBuildable where there are none.
ExitCode trainCommand(const TrainOptions& options);

}  // namespace liftarm::cli
