#include <cmath>

#include "objective/term.h"

namespace liftarm::objective {

double deviation(const Measures& m) {
  if (m.tallies.holes == 0) {
    return 0.0;
  }
  return std::sqrt(static_cast<double>(m.tallies.layerSquares) /
                   static_cast<double>(m.tallies.holes));
}

}  // namespace liftarm::objective
