#include "cli/best_of.h"

#include <tuple>

namespace liftarm::cli {

Standing standingOf(const nlohmann::ordered_json& report) {
  Standing standing;
  standing.buildable = report.value("buildable", false);
  for (const char* key : {"gaps", "collisions", "uncovered", "failedConnections"}) {
    standing.violations += report.value(key, 0);
  }
  standing.beams = report.value("beams", 0);
  standing.bricks = report.value("bricks", 0);
  standing.objective = report.value("objective", 0.0);
  standing.seed = report.value("seed", std::uint64_t{0});
  return standing;
}

bool isBetter(const Standing& a, const Standing& b) {
  return std::tuple(!a.buildable, a.violations, a.beams, a.bricks, a.objective, a.seed) <
         std::tuple(!b.buildable, b.violations, b.beams, b.bricks, b.objective, b.seed);
}

}  // namespace liftarm::cli
