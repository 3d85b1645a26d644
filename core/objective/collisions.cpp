#include "objective/term.h"

namespace liftarm::objective {

double collisions(const Measures& m) {
  if (m.tallies.holes == 0) {
    return 0.0;
  }
  return static_cast<double>(m.tallies.collisions) / static_cast<double>(m.tallies.holes);
}

}  // namespace liftarm::objective
