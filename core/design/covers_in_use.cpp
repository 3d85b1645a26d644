#include "design/covers_in_use.h"

namespace liftarm::design {

search::CoverTable coversInUse(const layout::LayoutProblem& problem, const Settings& settings) {
  if (!isPaperFamily(settings.method)) {
    return search::makeCoverTable(problem, settings.annealing);
  }
  search::AnnealingOptions options = settings.annealing;
  options.parts.frames = options.parts.axles = false;
  return search::makeCoverTable(problem, options, search::Bridging::kWherePossible);
}

}  // namespace liftarm::design
