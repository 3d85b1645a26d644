#pragma once

#include <array>
#include <cmath>

namespace liftarm::lattice {

inline constexpr double kMillimetresPerModule = 8.0;

//! \brief A principal axis. Positions and lengths are in modules (8 mm), Z is up, right-handed.
enum class Axis { kX = 0, kY = 1, kZ = 2 };

constexpr int index(Axis axis) {
  return static_cast<int>(axis);
}

constexpr Axis axisFromIndex(int i) {
  return static_cast<Axis>(i);
}

//! \brief Three real coordinates, in modules.
struct Vec3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  double& operator[](int i) { return i == 0 ? x : (i == 1 ? y : z); }

  double operator[](int i) const { return i == 0 ? x : (i == 1 ? y : z); }

  friend Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

  friend Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

  friend Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }

  friend Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }

  friend bool operator==(Vec3 a, Vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
};

inline double dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline double length(Vec3 a) {
  return std::sqrt(dot(a, a));
}

//! \pre a is not zero.
inline Vec3 normalized(Vec3 a) {
  return (1.0 / length(a)) * a;
}

inline Vec3 unitVector(Axis axis) {
  Vec3 v;
  v[index(axis)] = 1.0;
  return v;
}

//! \brief The principal axis that a unit vector runs along, either way.
inline Axis mainAxis(Vec3 unit) {
  return axisFromIndex(std::abs(unit.x) > 0.9 ? 0 : (std::abs(unit.y) > 0.9 ? 1 : 2));
}

//! \brief Three whole coordinates on the lattice of one module.
struct Cell {
  int x = 0;
  int y = 0;
  int z = 0;

  int& operator[](int i) { return i == 0 ? x : (i == 1 ? y : z); }

  int operator[](int i) const { return i == 0 ? x : (i == 1 ? y : z); }

  friend Cell operator+(Cell a, Cell b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

  friend Cell operator-(Cell a, Cell b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

  friend bool operator==(Cell a, Cell b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

  friend bool operator!=(Cell a, Cell b) { return !(a == b); }

  friend bool operator<(Cell a, Cell b) {
    return a.x != b.x ? a.x < b.x : (a.y != b.y ? a.y < b.y : a.z < b.z);
  }
};

inline Vec3 toVec3(Cell c) {
  return {static_cast<double>(c.x), static_cast<double>(c.y), static_cast<double>(c.z)};
}

//! \brief A rotation matrix, row-major; column j is the image of axis j.
struct Mat3 {
  std::array<double, 9> m{1, 0, 0, 0, 1, 0, 0, 0, 1};

  friend Vec3 operator*(const Mat3& a, Vec3 v) {
    return {a.m[0] * v.x + a.m[1] * v.y + a.m[2] * v.z,
            a.m[3] * v.x + a.m[4] * v.y + a.m[5] * v.z,
            a.m[6] * v.x + a.m[7] * v.y + a.m[8] * v.z};
  }

  friend Mat3 operator*(const Mat3& a, const Mat3& b);
};

Mat3 transposed(const Mat3& a);

//! \brief Of a map that keeps lengths: 1 if it turns, -1 if it mirrors, but for rounding.
double determinant(const Mat3& a);

//! \brief The rotation whose columns are x, y and z. \pre orthonormal and right-handed.
Mat3 fromColumns(Vec3 x, Vec3 y, Vec3 z);

//! \brief A rigid placement: p -> rotation * p + position.
struct Pose {
  Vec3 position;
  Mat3 rotation;

  [[nodiscard]] Vec3 apply(Vec3 p) const { return rotation * p + position; }
};

//! \brief First the inner placement, then the outer one.
inline Pose after(const Pose& outer, const Pose& inner) {
  return {outer.apply(inner.position), outer.rotation * inner.rotation};
}

//! \brief The 24 rotations that map the lattice onto itself, in a fixed order, identity first.
const std::array<Mat3, 24>& latticeRotations();

}  // namespace liftarm::lattice
