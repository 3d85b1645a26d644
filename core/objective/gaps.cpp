#include "objective/term.h"

namespace liftarm::objective {

double gaps(const Measures& m) {
  return static_cast<double>(m.tallies.gaps) / m.scale.nodes;
}

}  // namespace liftarm::objective
