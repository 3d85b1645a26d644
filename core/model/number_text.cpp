#include "model/number_text.h"

#include <cmath>
#include <cstddef>

#include "base/check.h"

namespace liftarm::model {

std::string numberText(double value, int decimals) {
  double scale = 1.0;
  for (int i = 0; i < decimals; ++i) {
    scale *= 10.0;
  }
  const double scaled = value * scale;
  LIFTARM_CHECK(std::isfinite(scaled) && std::abs(scaled) < 9e18, "number too large to be written");
  const long long whole = std::llround(scaled);
  std::string digits = std::to_string(whole < 0 ? -whole : whole);
  const auto places = static_cast<std::size_t>(decimals);
  if (digits.size() <= places) {
    digits.insert(0, places + 1 - digits.size(), '0');
  }
  std::string fraction = digits.substr(digits.size() - places);
  digits.resize(digits.size() - places);
  while (!fraction.empty() && fraction.back() == '0') {
    fraction.pop_back();
  }
  return (whole < 0 ? "-" : "") + digits + (fraction.empty() ? "" : "." + fraction);
}

}  // namespace liftarm::model
