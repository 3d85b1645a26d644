#include "objective/term.h"

namespace liftarm::objective {

double beamCount(const Measures& m) {
  return static_cast<double>(m.tallies.beams);
}

}  // namespace liftarm::objective
