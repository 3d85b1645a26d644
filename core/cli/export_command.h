#pragma once

#include <string>

#include "cli/solve_command.h"

namespace liftarm::cli {

//! \brief Options of `liftarm export`, `instructions` and `import`, as given.
struct ExportOptions {
  std::string modelPath;
  std::string output;  //!< empty: standard output; for `import`: NAME.model.json here
  std::string format;  //!< empty: what the output's name ends with
  bool json = false;
};

//! \brief Writes a model in another format (design/design_session.h, exportModel).
ExitCode exportCommand(const ExportOptions& options);

//! \brief Prints how a model is put together, step by step, with the parts of each.
//! \return kNotBuildable where it cannot be.
ExitCode instructionsCommand(const ExportOptions& options);

//! \brief Writes the model file of an LDraw document, and prints what of it was left out.
ExitCode importCommand(const ExportOptions& options);

}  // namespace liftarm::cli
