#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/status.h"

namespace liftarm::cli {

//! \brief What one search came to.
struct Solution {
  //! Of DESIGN 4, with its times, and beside them the processor's as seconds.processor.
  nlohmann::ordered_json report;
  std::string modelJson;
};

//! \brief Solves a sketch with one seed to the end. \return The solution, or why the input is
//! refused.
base::Result<Solution> solveOnce(const std::string& sketchJson,
                                 const nlohmann::ordered_json& settings);

//! \brief Solves a sketch with the seeds first, first + 1, ... in so many threads and keeps the
//! best (best_of.h). \details What comes out does not depend on the number of threads, but its
//! times. \param settings Without a seed. \param seeds, threads At least 1.
//! \return The best solution; its report has "seeds", one {"seed", "buildable", "beams", "bricks"}
//! for each, and the seconds of all as its total. Or why the input is refused.
base::Result<Solution> solveSeeds(const std::string& sketchJson,
                                  const nlohmann::ordered_json& settings,
                                  std::uint64_t first,
                                  int seeds,
                                  int threads);

}  // namespace liftarm::cli
