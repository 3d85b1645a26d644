#include "objective/term.h"

namespace liftarm::objective {

double holeCount(const Measures& m) {
  return static_cast<double>(m.tallies.holes);
}

}  // namespace liftarm::objective
