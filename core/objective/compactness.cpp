#include "objective/term.h"

namespace liftarm::objective {

double compactness(const Measures& m) {
  return static_cast<double>(m.componentRange) * static_cast<double>(m.componentRange);
}

}  // namespace liftarm::objective
