#include "core/analysis/linkages.h"

#include <cmath>
#include <cstddef>

#include <Eigen/Dense>

#include "analysis/union_find.h"
#include "core/helpers/models.h"

namespace liftarm::testing {

namespace {

using analysis::Link;
using analysis::Linkage;
using lattice::Vec3;

Linkage linkage(int bodies, std::vector<Link> links) {
  return {bodies, std::move(links)};
}

Link slide(int a, int b, Vec3 at, Vec3 axis) {
  Link link = hinge(a, b, at, axis);
  link.shifts = true;
  return link;
}

Linkage bracedSquare() {
  Linkage square = fourBar(8, 8);
  square.bodies = 5;
  square.links.push_back(hinge(0, 4, {0, 0, 0}, kZ));
  square.links.push_back(hinge(2, 4, {8, 8, 0}, kZ));
  return square;
}

//! Squares side by side whose rungs are shared, each rail one bar from rung to rung.
Linkage chainOfSquares(int squares) {
  Linkage chain;
  const auto rung = [](int i) { return 3 * i; };
  chain.bodies = 3 * squares + 1;
  for (int i = 0; i < squares; ++i) {
    for (const int side : {0, 1}) {
      const int rail = 3 * i + 1 + side;
      const double y = 5.0 * side;
      chain.links.push_back(hinge(rung(i), rail, {5.0 * i, y, 0}, kZ));
      chain.links.push_back(hinge(rail, rung(i + 1), {5.0 * i + 5, y, 0}, kZ));
    }
  }
  return chain;
}

//! Two long rails joined by parallel rungs: overconstrained, yet it moves.
Linkage parallelRungs(int rungs) {
  Linkage ladder;
  ladder.bodies = 2 + rungs;
  for (int i = 0; i < rungs; ++i) {
    ladder.links.push_back(hinge(0, 2 + i, {3.0 * i, 0, 0}, kZ));
    ladder.links.push_back(hinge(1, 2 + i, {3.0 * i + 3, 4, 0}, kZ));
  }
  return ladder;
}

Linkage scissor(int crosses) {
  Linkage result;
  result.bodies = 2 * crosses;
  for (int i = 0; i < crosses; ++i) {
    result.links.push_back(hinge(2 * i, 2 * i + 1, {4.0 * i + 2, 2, 0}, kZ));
    if (i > 0) {
      result.links.push_back(hinge(2 * i - 2, 2 * i + 1, {4.0 * i, 4, 0}, kZ));
      result.links.push_back(hinge(2 * i - 1, 2 * i, {4.0 * i, 0, 0}, kZ));
    }
  }
  return result;
}

//! Two plates joined by two legs of two plates each, hinges of a leg parallel: moves straight.
Linkage sarrus() {
  return linkage(6,
                 {hinge(0, 1, {0, -4, 0}, kX),
                  hinge(1, 2, {0, -7, 4}, kX),
                  hinge(2, 3, {0, -4, 8}, kX),
                  hinge(3, 4, {4, 0, 8}, kY),
                  hinge(4, 5, {7, 0, 4}, kY),
                  hinge(5, 0, {4, 0, 0}, kY)});
}

//! Skew four-bar with opposite sides alike, sin(twist) / length the same for all: moves, though
//! four hinges in general do not.
Linkage bennett(double stretch) {
  const double lengths[] = {4.0, 6.0 * stretch, 4.0, 6.0 * stretch};
  const double alpha = 0.6;
  const double beta = std::asin(std::sin(alpha) * 6.0 / 4.0);
  const double twists[] = {alpha, beta, alpha, beta};
  const double first = 1.1;
  const double second = 2 * std::atan(std::sin((beta + alpha) / 2) / std::sin((beta - alpha) / 2) /
                                      std::tan(first / 2));
  const double angles[] = {first, second, -first, -second};
  Linkage loop;
  loop.bodies = 4;
  Eigen::Affine3d frame = Eigen::Affine3d::Identity();
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector3d p = frame.translation();
    const Eigen::Vector3d z = frame.linear().col(2);
    loop.links.push_back(hinge(i, (i + 1) % 4, {p.x(), p.y(), p.z()}, {z.x(), z.y(), z.z()}));
    frame = frame * Eigen::AngleAxisd(angles[i], Eigen::Vector3d::UnitZ()) *
            Eigen::Translation3d(lengths[i], 0, 0) *
            Eigen::AngleAxisd(twists[i], Eigen::Vector3d::UnitX());
  }
  return loop;
}

//! A loop of hinges in no special places.
Linkage generalLoop(int hinges) {
  Linkage loop;
  loop.bodies = hinges;
  for (int i = 0; i < hinges; ++i) {
    const double t = i;
    loop.links.push_back(hinge(i,
                               (i + 1) % hinges,
                               {5 * std::cos(t), 5 * std::sin(1.3 * t), std::cos(2.1 * t)},
                               lattice::normalized({std::sin(3 * t) + 0.2, std::cos(5 * t), 0.7})));
  }
  return loop;
}

Linkage sphericalFourBar() {
  Linkage loop;
  loop.bodies = 4;
  const Vec3 axes[] = {{1, 0, 0.2}, {0, 1, 0.5}, {-1, 0.3, 0.4}, {0.2, -1, 0.8}};
  for (int i = 0; i < 4; ++i) {
    loop.links.push_back(hinge(i, (i + 1) % 4, {1, 2, 3}, lattice::normalized(axes[i])));
  }
  return loop;
}

//! Six plates hinged along all edges: by Cauchy's theorem it does not move.
Linkage boxOfPlates() {
  Linkage box;
  box.bodies = 6;  // plate 2k at coordinate k = 0, plate 2k + 1 at 4
  for (int k = 0; k < 3; ++k) {
    for (int side = 0; side < 4; ++side) {
      const int i = (k + 1) % 3;
      const int j = (k + 2) % 3;
      Vec3 at;
      Vec3 axis;
      at[i] = 4.0 * (side & 1);
      at[j] = 4.0 * (side >> 1);
      axis[k] = 1.0;
      box.links.push_back(hinge(2 * i + (side & 1), 2 * j + (side >> 1), at, axis));
    }
  }
  return box;
}

//! Twelve bars and eight corner pieces with one hinge to each of their three bars. Bars along x are
//! hinged about z, along y about x, along z about y.
Linkage cubeOfSinglePins() {
  Linkage cube;
  cube.bodies = 20;
  int bar = 8;
  for (int k = 0; k < 3; ++k) {
    for (int side = 0; side < 4; ++side, ++bar) {
      for (int end = 0; end < 2; ++end) {
        const int i = (k + 1) % 3;
        const int j = (k + 2) % 3;
        Vec3 at;
        at[i] = 8.0 * (side & 1);
        at[j] = 8.0 * (side >> 1);
        at[k] = 8.0 * end;
        Vec3 axis;
        axis[j] = 1.0;
        const int corner = (at.x > 0 ? 1 : 0) + (at.y > 0 ? 2 : 0) + (at.z > 0 ? 4 : 0);
        cube.links.push_back(hinge(corner, bar, at, axis));
      }
    }
  }
  return cube;
}

Eigen::Matrix<double, 3, 1> eigen(Vec3 v) {
  return {v.x, v.y, v.z};
}

//! Rows on the relative twist (linear at the origin, angular) that a link does not allow.
Eigen::MatrixXd rowsOf(const Link& link) {
  const Vec3 side =
      lattice::normalized(lattice::cross(link.axis, std::abs(link.axis.z) > 0.5 ? kX : kZ));
  const Vec3 other = lattice::cross(link.axis, side);
  std::vector<Eigen::Matrix<double, 1, 6>> rows;
  for (const Vec3 d : {side, other, link.axis}) {
    const bool along = d == link.axis;
    Eigen::Matrix<double, 1, 6> row;
    if (!along || !link.shifts) {
      // d . (v + w x p) = d . v + w . (p x d)
      row << eigen(d).transpose(), eigen(lattice::cross(link.at, d)).transpose();
      rows.push_back(row);
    }
    if (!along || !link.turns) {
      row << 0, 0, 0, eigen(d).transpose();
      rows.push_back(row);
    }
  }
  Eigen::MatrixXd result(rows.size(), 6);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    result.row(static_cast<Eigen::Index>(i)) = rows[i];
  }
  return result;
}

Eigen::MatrixXd constraintMatrix(const Linkage& linkage) {
  Eigen::MatrixXd matrix(0, 6 * linkage.bodies);
  for (const Link& link : linkage.links) {
    const Eigen::MatrixXd rows = rowsOf(link);
    const Eigen::Index first = matrix.rows();
    matrix.conservativeResize(first + rows.rows(), Eigen::NoChange);
    matrix.bottomRows(rows.rows()).setZero();
    matrix.block(first, 6 * link.a, rows.rows(), 6) -= rows;
    matrix.block(first, 6 * link.b, rows.rows(), 6) += rows;
  }
  return matrix;
}

}  // namespace

Link hinge(int a, int b, Vec3 at, Vec3 axis) {
  Link link;
  link.a = a;
  link.b = b;
  link.at = at;
  link.axis = axis;
  return link;
}

Linkage fourBar(double width, double height) {
  return linkage(4,
                 {hinge(0, 1, {width, 0, 0}, kZ),
                  hinge(1, 2, {width, height, 0}, kZ),
                  hinge(2, 3, {0, height, 0}, kZ),
                  hinge(3, 0, {0, 0, 0}, kZ)});
}

std::vector<Mechanism> knownMechanisms() {
  return {
      {"FourBar", fourBar(9, 4), 1},
      {"SquareOfSinglePins", fourBar(8, 8), 1},
      {"BracedSquare", bracedSquare(), 0},
      {"ChainOfThreeSquares", chainOfSquares(3), 3},
      {"ParallelRungs", parallelRungs(5), 1},
      {"Scissor", scissor(4), 1},
      {"ChainOfThirtySquares", chainOfSquares(30), 30},
      {"Sarrus", sarrus(), 1},
      {"Bennett", bennett(1.0), 1},
      {"BennettOfWrongLength", bennett(1.2), 0},
      {"LoopOfSixHinges", generalLoop(6), 0},
      {"LoopOfSevenHinges", generalLoop(7), 1},
      {"LoopOfNineHinges", generalLoop(9), 3},
      {"SphericalFourBar", sphericalFourBar(), 1},
      {"BoxOfPlates", boxOfPlates(), 0},
      // The three shears of a parallelepiped; the dense count says so too.
      {"CubeOfSinglePins", cubeOfSinglePins(), 3},
      {"TwoCoaxialPins", linkage(2, {hinge(0, 1, {}, kZ), hinge(0, 1, {0, 0, 3}, kZ)}), 1},
      {"TwoSeparatePins", linkage(2, {hinge(0, 1, {}, kZ), hinge(0, 1, {1, 0, 0}, kZ)}), 0},
      {"TwoCrossedPins", linkage(2, {hinge(0, 1, {}, kZ), hinge(0, 1, {}, kX)}), 0},
      {"Slide", linkage(2, {slide(0, 1, {}, kZ)}), 2},
      {"SlideOnAPin", linkage(2, {slide(0, 1, {}, kZ), hinge(0, 1, {0, 0, 5}, kZ)}), 1},
      {"FanOnOneAxle",
       linkage(4, {slide(0, 1, {}, kZ), hinge(0, 2, {0, 0, 1}, kZ), slide(0, 3, {0, 0, 2}, kZ)}),
       5},
      {"SeparateBodies", linkage(3, {hinge(0, 1, {}, kZ)}), 1}};
}

analysis::FreedomsQuery queryOf(const Linkage& linkage) {
  const auto bodies = static_cast<std::size_t>(linkage.bodies);
  return {linkage, std::vector<bool>(bodies, true), std::vector<double>(bodies, 1.0), {}};
}

int nullityByReflections(const Linkage& linkage) {
  const Eigen::MatrixXd matrix = constraintMatrix(linkage);
  // Singular values would say the same and take three times as long to compile as all else here.
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(matrix);
  factors.setThreshold(1e-7);
  const int rank = static_cast<int>(factors.rank());
  analysis::UnionFind assemblies(static_cast<std::size_t>(linkage.bodies));
  for (const Link& link : linkage.links) {
    assemblies.join(link.a, link.b);
  }
  int nullity = 6 * linkage.bodies - rank;
  for (int i = 0; i < linkage.bodies; ++i) {
    nullity -= assemblies.find(i) == i ? 6 : 0;
  }
  return nullity;
}

double violation(const Linkage& linkage, const std::vector<analysis::Twist>& twists) {
  Eigen::VectorXd velocities(6 * linkage.bodies);
  for (std::size_t i = 0; i < twists.size(); ++i) {
    velocities.segment<6>(6 * static_cast<Eigen::Index>(i)) << eigen(twists[i].linear),
        eigen(twists[i].angular);
  }
  return (constraintMatrix(linkage) * velocities).cwiseAbs().maxCoeff();
}

}  // namespace liftarm::testing
