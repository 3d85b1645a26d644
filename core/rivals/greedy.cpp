#include "rivals/greedy.h"

#include <algorithm>
#include <numeric>

namespace liftarm::rivals {

namespace {

constexpr double kOffLineCost = 0.1;  // of a layer away from the line, against a gap

int cheapestLayer(std::vector<double> costs) {
  for (int layer = -guide::kMaxLayer; layer <= guide::kMaxLayer; ++layer) {
    costs[static_cast<std::size_t>(layer + guide::kMaxLayer)] +=
        kOffLineCost * static_cast<double>(layer < 0 ? -layer : layer);
  }
  return static_cast<int>(std::min_element(costs.begin(), costs.end()) - costs.begin()) -
         guide::kMaxLayer;
}

}  // namespace

bool Greedy::step() {
  std::vector<int> runs(problem().graph.runs.size());
  std::iota(runs.begin(), runs.end(), 0);
  std::vector<search::PaperPlacement> found = beams().placements(runs, options().paper.corners);
  int most = 0;
  for (const search::PaperPlacement& p : found) {
    most = std::max(most, p.covers);
  }
  found.erase(std::remove_if(found.begin(),
                             found.end(),
                             [&](const search::PaperPlacement& p) { return p.covers < most; }),
              found.end());
  if (!found.empty()) {
    const auto& p = found[rng()->below(static_cast<std::uint32_t>(found.size()))];
    beams().add(p, cheapestLayer(paperOperator().layerCosts(beams(), p)));
  }
  const Judgement judgement = judge().look(&beams());
  judge().keep(&beams());
  offer(beams(), judgement);
  edgesLeft_ = judgement.uncovered;
  edgesAtFirst_ = std::max(edgesAtFirst_, edgesLeft_);
  return found.empty() || edgesLeft_ == 0;
}

double Greedy::share() const {
  return 1.0 - static_cast<double>(edgesLeft_) / static_cast<double>(edgesAtFirst_);
}

}  // namespace liftarm::rivals
