#include "objective/term.h"

namespace liftarm::objective {

double pinHeadRatio(const Measures& m) {
  // No connection at all counts as perfect, or leaving beams unjoined would pay (DESIGN 7).
  if (m.tallies.mechanisms == 0) {
    return 0.0;
  }
  return 1.0 - m.tallies.pinHeadRatios / static_cast<double>(m.tallies.mechanisms);
}

}  // namespace liftarm::objective
