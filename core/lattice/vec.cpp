#include "lattice/vec.h"

namespace liftarm::lattice {

namespace {

std::array<Mat3, 24> makeLatticeRotations() {
  std::array<Mat3, 24> all;
  std::size_t count = 0;
  for (int ix = 0; ix < 3; ++ix) {
    for (int sx = 1; sx >= -1; sx -= 2) {
      for (int iy = 0; iy < 3; ++iy) {
        for (int sy = 1; sy >= -1; sy -= 2) {
          if (iy == ix) {
            continue;
          }
          const Vec3 x = static_cast<double>(sx) * unitVector(axisFromIndex(ix));
          const Vec3 y = static_cast<double>(sy) * unitVector(axisFromIndex(iy));
          all[count++] = fromColumns(x, y, cross(x, y));
        }
      }
    }
  }
  return all;
}

}  // namespace

Mat3 operator*(const Mat3& a, const Mat3& b) {
  Mat3 c;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      c.m[3 * i + j] =
          a.m[3 * i] * b.m[j] + a.m[3 * i + 1] * b.m[3 + j] + a.m[3 * i + 2] * b.m[6 + j];
    }
  }
  return c;
}

Mat3 transposed(const Mat3& a) {
  return Mat3{{a.m[0], a.m[3], a.m[6], a.m[1], a.m[4], a.m[7], a.m[2], a.m[5], a.m[8]}};
}

Mat3 fromColumns(Vec3 x, Vec3 y, Vec3 z) {
  return Mat3{{x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z}};
}

const std::array<Mat3, 24>& latticeRotations() {
  static const std::array<Mat3, 24> kRotations = makeLatticeRotations();
  return kRotations;
}

}  // namespace liftarm::lattice
