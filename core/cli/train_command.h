#pragma once

#include <string>
#include <vector>

#include "cli/solve_command.h"

namespace liftarm::cli {

//! \brief Options of `liftarm train`, as given.
struct TrainOptions {
  std::vector<int> way;    //!< from the first shaft to the last, modules: two numbers
  double ratio = 1.0;      //!< turns of the first shaft for one turn of the last
  double tolerance = 3.0;  //!< per cent of the ratio
  std::string folder;      //!< empty: no file
  bool json = false;
};

//! \brief Finds the gears that couple two parallel shafts (gears/train.h) and prints them, shaft by
//! shaft. Into a folder it writes Gear-train.sketch.json: a frame round them, to be solved. \return
//! kNotBuildable where there are none.
ExitCode trainCommand(const TrainOptions& options);

}  // namespace liftarm::cli
