#include "objective/term.h"

namespace liftarm::objective {

double connectionCost(const Measures& m) {
  return m.tallies.connectionCost;
}

}  // namespace liftarm::objective
