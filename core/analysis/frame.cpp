#include "analysis/frame.h"

#include <cmath>
#include <cstddef>

#include <Eigen/Dense>

namespace liftarm::analysis {

namespace {

using lattice::Mat3;
using lattice::Vec3;
using Vector12 = Eigen::Matrix<double, 12, 1>;
using Matrix12 = Eigen::Matrix<double, 12, 12, Eigen::RowMajor>;

Vec3 column(const Mat3& m, int j) {
  const auto c = static_cast<std::size_t>(j);
  return {m.m[c], m.m[3 + c], m.m[6 + c]};
}

Vec3 nodeAt(const Frame& frame, int node) {
  return frame.nodes[static_cast<std::size_t>(node)];
}

//! World components to local ones, for each of the four vectors of an element.
Vector12 toLocal(const Mat3& axes, const Vector12& world) {
  Vector12 local;
  for (int block = 0; block < 4; ++block) {
    const Vec3 v{world(3 * block), world(3 * block + 1), world(3 * block + 2)};
    for (int i = 0; i < 3; ++i) {
      local(3 * block + i) = lattice::dot(column(axes, i), v);
    }
  }
  return local;
}

Vector12 displacementsOf(const FrameElement& element, const std::vector<Six>& all) {
  Vector12 u;
  for (int i = 0; i < 6; ++i) {
    const auto k = static_cast<std::size_t>(i);
    u(i) = all[static_cast<std::size_t>(element.a)][k];
    u(6 + i) = all[static_cast<std::size_t>(element.b)][k];
  }
  return u;
}

//! Bending in one plane. `v` and `r` are the places of the deflection and the rotation at end a;
//! `sign` is that of the rotation: v' = sign * r.
void addBending(Matrix12& k, double ei, double gas, double length, std::array<int, 2> place) {
  const int v = place[0];
  const int r = place[1];
  const double sign = v == 1 ? 1.0 : -1.0;
  const double phi = 12.0 * ei / (gas * length * length);
  const double c = ei / (length * length * length * (1.0 + phi));
  const double cross = sign * 6.0 * length * c;
  k(v, v) = k(v + 6, v + 6) = 12.0 * c;
  k(v, v + 6) = k(v + 6, v) = -12.0 * c;
  k(r, r) = k(r + 6, r + 6) = (4.0 + phi) * length * length * c;
  k(r, r + 6) = k(r + 6, r) = (2.0 - phi) * length * length * c;
  k(v, r) = k(r, v) = k(v, r + 6) = k(r + 6, v) = cross;
  k(v + 6, r) = k(r, v + 6) = k(v + 6, r + 6) = k(r + 6, v + 6) = -cross;
}

}  // namespace

double lengthOf(const Frame& frame, const FrameElement& element) {
  return lattice::length(nodeAt(frame, element.b) - nodeAt(frame, element.a));
}

Mat3 axesOf(const Frame& frame, const FrameElement& element) {
  constexpr double kParallel = 1e-6;
  const Vec3 x = lattice::normalized(nodeAt(frame, element.b) - nodeAt(frame, element.a));
  Vec3 z = element.up - lattice::dot(element.up, x) * x;
  if (lattice::length(z) < kParallel) {
    // Any direction across the bar will do: it has no holes across.
    const Vec3 other = std::abs(x.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
    z = other - lattice::dot(other, x) * x;
  }
  z = lattice::normalized(z);
  return lattice::fromColumns(x, lattice::cross(z, x), z);
}

std::array<double, 144> stiffnessOf(const Frame& frame, const FrameElement& element) {
  const Section& s = frame.sections[static_cast<std::size_t>(element.section)];
  const double e = frame.material.youngsModulus;
  const double g = frame.material.shearModulus();
  const double l = lengthOf(frame, element);
  Matrix12 k = Matrix12::Zero();
  k(0, 0) = k(6, 6) = e * s.area / l;
  k(0, 6) = k(6, 0) = -e * s.area / l;
  k(3, 3) = k(9, 9) = g * s.torsion / l;
  k(3, 9) = k(9, 3) = -g * s.torsion / l;
  addBending(k, e * s.inertiaZ, g * s.shearY, l, {1, 5});
  addBending(k, e * s.inertiaY, g * s.shearZ, l, {2, 4});
  std::array<double, 144> result{};
  Eigen::Map<Matrix12>(result.data()) = k;
  return result;
}

std::array<double, 12> equalNodalLoads(const Frame& frame, const FrameElement& element) {
  const double l = lengthOf(frame, element);
  const Vec3 half = (l / 2.0) * element.load;
  const Vec3 x = lattice::normalized(nodeAt(frame, element.b) - nodeAt(frame, element.a));
  const Vec3 moment = (l * l / 12.0) * lattice::cross(x, element.load);
  return {half.x,
          half.y,
          half.z,
          moment.x,
          moment.y,
          moment.z,
          half.x,
          half.y,
          half.z,
          -moment.x,
          -moment.y,
          -moment.z};
}

std::vector<Six> nodalLoads(const Frame& frame) {
  std::vector<Six> loads = frame.loads;
  loads.resize(frame.nodes.size(), Six{});
  for (const FrameElement& element : frame.elements) {
    const std::array<double, 12> equal = equalNodalLoads(frame, element);
    for (std::size_t i = 0; i < 6; ++i) {
      loads[static_cast<std::size_t>(element.a)][i] += equal[i];
      loads[static_cast<std::size_t>(element.b)][i] += equal[6 + i];
    }
  }
  return loads;
}

SectionForces forcesAt(const Frame& frame,
                       const FrameElement& element,
                       const std::vector<Six>& displacements,
                       double share) {
  const Mat3 axes = axesOf(frame, element);
  std::array<double, 144> stiffness = stiffnessOf(frame, element);
  std::array<double, 12> equal = equalNodalLoads(frame, element);
  const Vector12 u = toLocal(axes, displacementsOf(element, displacements));
  const Vector12 f = Eigen::Map<Matrix12>(stiffness.data()) * u -
                     toLocal(axes, Eigen::Map<Vector12>(equal.data()));
  const double x = share * lengthOf(frame, element);
  const Vec3 q{lattice::dot(column(axes, 0), element.load),
               lattice::dot(column(axes, 1), element.load),
               lattice::dot(column(axes, 2), element.load)};
  // Balance of the stretch from end a to x.
  return {-(f(0) + q.x * x),
          -(f(1) + q.y * x),
          -(f(2) + q.z * x),
          -f(3),
          -(f(4) + f(2) * x + q.z * x * x / 2.0),
          -(f(5) - f(1) * x - q.y * x * x / 2.0)};
}

double vonMises(const Section& section, const SectionForces& f) {
  const double normal = std::abs(f.normal) / section.netArea +
                        std::abs(f.momentY) / section.modulusY +
                        std::abs(f.momentZ) / section.modulusZ;
  const double shear = std::abs(f.torque) / section.modulusT +
                       std::sqrt(f.shearY * f.shearY + f.shearZ * f.shearZ) / section.netShear;
  return std::sqrt(normal * normal + 3.0 * shear * shear);
}

Vec3 middleDisplacement(const Frame& frame,
                        const FrameElement& element,
                        const std::vector<Six>& displacements) {
  const Vector12 u = displacementsOf(element, displacements);
  const Vec3 along = nodeAt(frame, element.b) - nodeAt(frame, element.a);
  const Vec3 mean = 0.5 * Vec3{u(0) + u(6), u(1) + u(7), u(2) + u(8)};
  const Vec3 turned{u(3) - u(9), u(4) - u(10), u(5) - u(11)};
  return mean + 0.125 * lattice::cross(turned, along);
}

std::array<std::array<double, 12>, 6> springRows(const Frame& frame, const FrameSpring& spring) {
  std::array<std::array<double, 12>, 6> rows{};
  const auto put = [&](std::size_t row, std::size_t from, Vec3 v) {
    rows[row][from] = v.x;
    rows[row][from + 1] = v.y;
    rows[row][from + 2] = v.z;
  };
  const Vec3 armA = spring.at - nodeAt(frame, spring.a);
  const Vec3 armB = spring.b < 0 ? Vec3{} : spring.at - nodeAt(frame, spring.b);
  for (int i = 0; i < 3; ++i) {
    const auto row = static_cast<std::size_t>(i);
    const Vec3 n = column(spring.axes, i);
    put(row, 0, -n);
    put(row, 3, -lattice::cross(armA, n));
    put(row + 3, 3, -n);
    if (spring.b >= 0) {
      put(row, 6, n);
      put(row, 9, lattice::cross(armB, n));
      put(row + 3, 9, n);
    }
  }
  return rows;
}

Six springForces(const Frame& frame,
                 const FrameSpring& spring,
                 const std::vector<Six>& displacements) {
  const std::array<std::array<double, 12>, 6> rows = springRows(frame, spring);
  Six forces{};
  for (std::size_t i = 0; i < 6; ++i) {
    double apart = 0.0;
    for (std::size_t k = 0; k < 6; ++k) {
      apart += rows[i][k] * displacements[static_cast<std::size_t>(spring.a)][k];
      if (spring.b >= 0) {
        apart += rows[i][6 + k] * displacements[static_cast<std::size_t>(spring.b)][k];
      }
    }
    forces[i] = spring.stiffness[i] * apart;
  }
  return forces;
}

}  // namespace liftarm::analysis
