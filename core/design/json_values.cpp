#include "design/json_values.h"

#include <cmath>

namespace liftarm::design {

double rounded(double value, int decimals) {
  constexpr double kExact = 9007199254740992.0;  // whole numbers below it are doubles
  double scale = 1.0;
  for (int i = 0; i < decimals; ++i) {
    scale *= 10.0;
  }
  const double scaled = value * scale;
  if (!(std::abs(scaled) < kExact)) {
    return value;
  }
  // A quotient of two exact doubles is rounded once, just as the decimal text would be when read.
  return static_cast<double>(std::llround(scaled)) / scale;
}

nlohmann::ordered_json pointJson(lattice::Vec3 p, int decimals) {
  return nlohmann::ordered_json::array(
      {rounded(p.x, decimals), rounded(p.y, decimals), rounded(p.z, decimals)});
}

}  // namespace liftarm::design
