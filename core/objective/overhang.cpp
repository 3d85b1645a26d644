#include "objective/term.h"

namespace liftarm::objective {

double overhang(const Measures& m) {
  return static_cast<double>(m.tallies.overhang);
}

}  // namespace liftarm::objective
