#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace liftarm::cli {

//! What the command returns to the shell (DESIGN 4).
enum class ExitCode : int {
  kBuildable = 0,
  kRefused = 1,
  kNotBuildable = 2,
  kFailed = 3,  //!< the machine could not do it: a full disk, no memory
};

//! \brief Options of `liftarm solve`, as given.
struct SolveOptions {
  std::string sketchPath;
  std::string folder = ".";
  std::string seed;  //!< empty: the default
  std::string preset;
  std::string method;
  std::vector<std::string> settings;  //!< "key=value"
  int seeds = 1;                      //!< how many are tried, from `seed` on
  int threads = 1;
  bool json = false;
  bool quiet = false;  //!< no files
};

//! \brief Solves a sketch, writes NAME.model.json, NAME.mpd and NAME.parts.csv, prints the report.
//! Messages about refused input go to standard error, one line.
ExitCode solveCommand(const SolveOptions& options);

//! \brief Checks a model file and prints the answer.
ExitCode checkCommand(const std::string& modelPath, bool json);

//! \brief Prints the symmetries that a sketch has but does not name, in its own format.
ExitCode symmetriesCommand(const std::string& sketchPath, bool json);

//! \brief Prints every placement of the parts in use (design/placements.h) as one JSON object.
//! \param options Those of `solve` that say what is in use.
ExitCode placementsCommand(const SolveOptions& options);

//! \brief Prints stage one before and after (design/stage_one.h) as one JSON object.
ExitCode stageOneCommand(const SolveOptions& options);

//! \brief Prints the stress of a model under loads (design/design_session.h, analyseStressJson) as
//! one JSON object. \param optionsJson As there; empty: its weight alone.
ExitCode stressCommand(const std::string& modelPath, const std::string& optionsJson);

//! \brief Prints the facts about all parts (core/parts/catalogue.json), for those who judge models
//! with programs of their own.
ExitCode partsCommand();

//! \brief Prints one line on standard error. \return kRefused, so that a caller can return it.
ExitCode refuse(const std::string& message);

//! \brief The same for what is not the input's fault. \return kFailed.
ExitCode fail(const std::string& message);

//! \brief Writes to standard output, to its end. \return False where not all of it arrived.
bool print(const std::string& text);

}  // namespace liftarm::cli
