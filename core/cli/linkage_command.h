#pragma once

#include <string>

#include "cli/solve_command.h"

namespace liftarm::cli {

//! \brief Options of `liftarm linkage`, as given.
struct LinkageOptions {
  std::string pathFile;
  std::string kind;    //!< empty: the file's
  std::string turns;   //!< empty: the file's
  std::string folder;  //!< empty: no files
  bool json = false;
};

//! \brief Finds linkages for a drawn path (linkages/linkage_json.h), prints them and writes
//! DIR/NAME-1.sketch.json and so on, the best first. \return kNotBuildable where there is none.
ExitCode linkageCommand(const LinkageOptions& options);

}  // namespace liftarm::cli
