#include "objective/term.h"

namespace liftarm::objective {

double hinges(const Measures& m) {
  return static_cast<double>(m.tallies.hinges);
}

}  // namespace liftarm::objective
