#include "lattice/vec.h"

namespace liftarm::lattice {

namespace {

//! \brief The six signed axes in the order +x, -x, +y, -y, +z, -z.
Vec3 signedAxis(int i) {
  return (i % 2 == 0 ? 1.0 : -1.0) * unitVector(axisFromIndex(i / 2));
}

std::array<Mat3, 24> makeLatticeRotations() {
  std::array<Mat3, 24> all;
  std::size_t count = 0;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      if (i / 2 != j / 2) {
        all[count++] =
            fromColumns(signedAxis(i), signedAxis(j), cross(signedAxis(i), signedAxis(j)));
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

double determinant(const Mat3& a) {
  const Vec3 x{a.m[0], a.m[3], a.m[6]};
  const Vec3 y{a.m[1], a.m[4], a.m[7]};
  const Vec3 z{a.m[2], a.m[5], a.m[8]};
  return dot(cross(x, y), z);
}

Mat3 fromColumns(Vec3 x, Vec3 y, Vec3 z) {
  return Mat3{{x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z}};
}

const std::array<Mat3, 24>& latticeRotations() {
  static const std::array<Mat3, 24> kRotations = makeLatticeRotations();
  return kRotations;
}

}  // namespace liftarm::lattice
