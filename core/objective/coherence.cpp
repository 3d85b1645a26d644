#include "objective/term.h"

namespace liftarm::objective {

double coherence(const Measures& m) {
  return static_cast<double>(m.tallies.failedConnections) / m.scale.edges;
}

}  // namespace liftarm::objective
