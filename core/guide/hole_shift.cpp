#include "guide/hole_shift.h"

#include <cmath>
#include <cstddef>

namespace liftarm::guide {

double holeShiftOf(const std::vector<lattice::Vec3>& nodes, const std::vector<int>& ofRun) {
  constexpr double kRounding = 1e-6;  // modules
  const lattice::Vec3 span = nodes[static_cast<std::size_t>(ofRun.back())] -
                             nodes[static_cast<std::size_t>(ofRun.front())];
  const double excess = lattice::length(span) - static_cast<double>(ofRun.size() - 1);
  return std::abs(excess) < kRounding ? 0.0 : 0.5 * excess;
}

}  // namespace liftarm::guide
