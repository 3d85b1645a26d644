#include "objective/term.h"

namespace liftarm::objective {

double violations(const Measures& m) {
  return static_cast<double>(m.tallies.violations());
}

}  // namespace liftarm::objective
