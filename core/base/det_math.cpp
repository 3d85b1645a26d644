#include "base/det_math.h"

#include <cstdint>
#include <cstring>

namespace liftarm::base {

namespace {

constexpr double kLn2 = 0.6931471805599453;
constexpr double kPi = 3.141592653589793;

double scaleByPowerOfTwo(double x, int exponent) {
  const auto bits = static_cast<std::uint64_t>(1023 + exponent) << 52U;
  double factor = 0.0;
  std::memcpy(&factor, &bits, sizeof factor);
  return x * factor;
}

int nearestInt(double x) {
  return static_cast<int>(x < 0.0 ? x - 0.5 : x + 0.5);
}

double sinSeries(double x) {
  double term = x;
  double sum = x;
  for (int k = 1; k <= 9; ++k) {
    term *= -x * x / static_cast<double>((2 * k) * (2 * k + 1));
    sum += term;
  }
  return sum;
}

double cosSeries(double x) {
  double term = 1.0;
  double sum = 1.0;
  for (int k = 1; k <= 10; ++k) {
    term *= -x * x / static_cast<double>((2 * k - 1) * (2 * k));
    sum += term;
  }
  return sum;
}

double quadrantSine(double x, int quadrant) {
  switch (quadrant & 3) {
    case 0:
      return sinSeries(x);
    case 1:
      return cosSeries(x);
    case 2:
      return -sinSeries(x);
    default:
      return -cosSeries(x);
  }
}

double atanPositive(double x) {
  if (x > 1.0) {
    return kPi / 2.0 - atanPositive(1.0 / x);
  }
  // Two halvings of the angle bring the argument below 0.2, where the series is short.
  double scale = 1.0;
  for (int halving = 0; halving < 2; ++halving) {
    double root = 1.0 + x * x;
    double guess = root;
    for (int i = 0; i < 40 && guess * guess > root * (1.0 + 1e-16); ++i) {
      guess = 0.5 * (guess + root / guess);
    }
    x = x / (1.0 + guess);
    scale *= 2.0;
  }
  double power = x;
  double sum = x;
  for (int k = 1; k <= 12; ++k) {
    power *= -x * x;
    sum += power / static_cast<double>(2 * k + 1);
  }
  return scale * sum;
}

}  // namespace

double detExp(double x) {
  if (x < -700.0) {
    return 0.0;
  }
  x = x > 700.0 ? 700.0 : x;
  const int exponent = nearestInt(x / kLn2);
  const double rest = x - static_cast<double>(exponent) * kLn2;
  double term = 1.0;
  double sum = 1.0;
  for (int k = 1; k <= 14; ++k) {
    term *= rest / static_cast<double>(k);
    sum += term;
  }
  return scaleByPowerOfTwo(sum, exponent);
}

double detLog(double x) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  const int exponent = static_cast<int>((bits >> 52U) & 0x7ffU) - 1023;
  double mantissa = scaleByPowerOfTwo(x, -exponent);
  double shift = static_cast<double>(exponent);
  if (mantissa > 1.4142135623730951) {
    mantissa *= 0.5;
    shift += 1.0;
  }
  const double t = (mantissa - 1.0) / (mantissa + 1.0);
  double power = t;
  double sum = t;
  for (int k = 1; k <= 12; ++k) {
    power *= t * t;
    sum += power / static_cast<double>(2 * k + 1);
  }
  return 2.0 * sum + shift * kLn2;
}

double detSin(double angle) {
  const int quadrant = nearestInt(angle / (kPi / 2.0));
  return quadrantSine(angle - static_cast<double>(quadrant) * (kPi / 2.0), quadrant);
}

double detCos(double angle) {
  const int quadrant = nearestInt(angle / (kPi / 2.0));
  return quadrantSine(angle - static_cast<double>(quadrant) * (kPi / 2.0), quadrant + 1);
}

double detAtan2(double y, double x) {
  if (x == 0.0 && y == 0.0) {
    return 0.0;
  }
  const double ax = x < 0.0 ? -x : x;
  const double ay = y < 0.0 ? -y : y;
  double angle = ax == 0.0 ? kPi / 2.0 : atanPositive(ay / ax);
  angle = x < 0.0 ? kPi - angle : angle;
  return y < 0.0 ? -angle : angle;
}

}  // namespace liftarm::base
