#include "objective/term.h"

namespace liftarm::objective {

double symmetry(const Measures& m) {
  return m.symmetryDeviation;
}

}  // namespace liftarm::objective
