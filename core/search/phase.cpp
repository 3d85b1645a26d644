#include "search/phase.h"

namespace liftarm::search {

bool Phase::passes(double limit) {
  SearchState& state = *state_;
  return state.layout().settle([&] { return state.measure() > limit; }) && state.measure() <= limit;
}

std::uint64_t roundLength(const AnnealingOptions& options, double share, std::size_t runs) {
  const double perRuns = static_cast<double>(options.iterationsPerRun) * static_cast<double>(runs);
  return options.minIterations + static_cast<std::uint64_t>(share * perRuns);
}

}  // namespace liftarm::search
