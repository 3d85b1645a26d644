#include "objective/term.h"

namespace liftarm::objective {

double beamLength(const Measures& m) {
  return static_cast<double>(m.tallies.holes) / m.scale.nodes;
}

}  // namespace liftarm::objective
