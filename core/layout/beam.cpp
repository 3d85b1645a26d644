#include "layout/beam.h"

#include <algorithm>

namespace liftarm::layout {

std::vector<int> inlinePins(const guide::GuideRun& run, const Beam& a, const Beam& b) {
  std::vector<int> pins;
  const int first = std::max(a.start, b.start);
  const int last = std::min(a.last(), b.last());
  if (a.layer - b.layer != 1 && b.layer - a.layer != 1) {
    return pins;
  }
  for (int i = first; i <= last; ++i) {
    const bool junction = std::find(run.junctionIndices.begin(), run.junctionIndices.end(), i) !=
                          run.junctionIndices.end();
    if (!junction) {
      pins.push_back(i);
    }
  }
  if (pins.size() > 2) {
    pins = {pins.front(), pins.back()};
  }
  return pins;
}

int partsOfBeam(int holes) {
  return holes == 4 || holes == 6 ? 2 : 1;
}

}  // namespace liftarm::layout
