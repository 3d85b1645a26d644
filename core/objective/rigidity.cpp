#include "objective/term.h"

namespace liftarm::objective {

double rigidity(const Measures& m) {
  return static_cast<double>(m.rigidSubsets) / m.scale.branching;
}

}  // namespace liftarm::objective
