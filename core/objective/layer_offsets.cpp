#include "objective/term.h"

namespace liftarm::objective {

double layerOffsets(const Measures& m) {
  return static_cast<double>(m.tallies.layerSquares);
}

}  // namespace liftarm::objective
