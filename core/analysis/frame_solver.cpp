#include "analysis/frame_solver.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include "base/rng.h"

namespace liftarm::analysis {

// Contributor notes. The scaled matrix is shifted by kShift, so that a mechanism can be factorised
// as well; the shift is taken out of the solution by refinement. Pivots of the unshifted matrix
// would tell of a mechanism too, but not how it moves, and their size depends on the ordering.

namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;
using lattice::Vec3;

constexpr double kShift = 1e-12;
// Motions that nothing resists come out at 1e-14 and less; the softest real frames at 1e-8 and
// more.
constexpr double kSingular = 1e-11;
// A motion that nothing resists grows 1e12-fold in a step, any other 1e9-fold at most.
constexpr int kPowerSteps = 3;
constexpr int kRefinements = 8;
constexpr double kResidual = 1e-13;
constexpr double kWorthwhile = 0.25;  // a refinement that leaves more of the residual is the last

using Element = Eigen::Matrix<double, 12, 12, Eigen::RowMajor>;

Triplets elementTriplets(const Frame& frame) {
  Triplets triplets;
  triplets.reserve(frame.elements.size() * 78 + frame.nodes.size() * 21);
  for (const FrameElement& element : frame.elements) {
    std::array<double, 144> local = stiffnessOf(frame, element);
    const lattice::Mat3 axes = axesOf(frame, element);
    Element turn = Element::Zero();
    for (int block = 0; block < 4; ++block) {
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          turn(3 * block + i, 3 * block + j) = axes.m[static_cast<std::size_t>(3 * j + i)];
        }
      }
    }
    const Element k = turn.transpose() * Eigen::Map<Element>(local.data()) * turn;
    for (int i = 0; i < 12; ++i) {
      for (int j = 0; j < 12; ++j) {
        const int row = 6 * (i < 6 ? element.a : element.b) + i % 6;
        const int col = 6 * (j < 6 ? element.a : element.b) + j % 6;
        if (row >= col) {
          triplets.emplace_back(row, col, k(i, j));
        }
      }
    }
  }
  return triplets;
}

void addSpring(const Frame& frame, const FrameSpring& spring, Triplets& triplets) {
  const std::array<std::array<double, 12>, 6> rows = springRows(frame, spring);
  const int count = spring.b < 0 ? 6 : 12;
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      const int row = 6 * (i < 6 ? spring.a : spring.b) + i % 6;
      const int col = 6 * (j < 6 ? spring.a : spring.b) + j % 6;
      if (row < col) {
        continue;
      }
      double value = 0.0;
      for (std::size_t k = 0; k < 6; ++k) {
        value += spring.stiffness[k] * rows[k][static_cast<std::size_t>(i)] *
                 rows[k][static_cast<std::size_t>(j)];
      }
      triplets.emplace_back(row, col, value);
    }
  }
}

}  // namespace

struct FrameSolver::State {
  const Frame* frame = nullptr;
  Triplets fixed;         // all but contacts
  Eigen::VectorXd scale;  // 1 / sqrt of the diagonal with all contacts
  Matrix matrix;          // scaled, not shifted, lower triangle
  Eigen::SimplicialLDLT<Matrix, Eigen::Lower> factor;
  Eigen::VectorXd mode;  // scaled, of the least eigenvalue found
  double least = 0.0;
  bool ordered = false;

  [[nodiscard]] Eigen::VectorXd times(const Eigen::VectorXd& x) const {
    return matrix.selfadjointView<Eigen::Lower>() * x;
  }

  void findLeast();
};

//! Inverse iteration from a fixed random start.
void FrameSolver::State::findLeast() {
  base::Rng rng(1);
  mode.resize(matrix.rows());
  for (Eigen::Index i = 0; i < mode.size(); ++i) {
    mode(i) = static_cast<double>(rng.below(2001)) / 1000.0 - 1.0;
  }
  mode.normalize();
  least = 1.0;
  for (int step = 0; step < kPowerSteps; ++step) {
    mode = factor.solve(mode);
    mode.normalize();
    least = std::min(least, std::abs(mode.dot(times(mode))));
  }
}

FrameSolver::FrameSolver(const Frame& frame) : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.frame = &frame;
  s.fixed = elementTriplets(frame);
  for (const FrameSpring& spring : frame.springs) {
    addSpring(frame, spring, s.fixed);
  }
  Eigen::VectorXd diagonal =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(6 * frame.nodes.size()));
  Triplets all;
  for (const FrameSpring& contact : frame.contacts) {
    addSpring(frame, contact, all);
  }
  for (const Triplets* triplets : {&s.fixed, &all}) {
    for (const Eigen::Triplet<double>& t : *triplets) {
      if (t.row() == t.col()) {
        diagonal(t.row()) += t.value();
      }
    }
  }
  s.scale = diagonal.unaryExpr([](double d) { return d > 0.0 ? 1.0 / std::sqrt(d) : 1.0; });
  // Room for any contact on any node, so that one ordering serves all.
  for (int node = 0; node < static_cast<int>(frame.nodes.size()); ++node) {
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j <= i; ++j) {
        s.fixed.emplace_back(6 * node + i, 6 * node + j, 0.0);
      }
    }
  }
}

FrameSolver::~FrameSolver() = default;

bool FrameSolver::prepare(const std::vector<bool>& active) {
  State& s = *state_;
  Triplets triplets = s.fixed;
  for (std::size_t i = 0; i < active.size(); ++i) {
    if (active[i]) {
      addSpring(*s.frame, s.frame->contacts[i], triplets);
    }
  }
  for (Eigen::Triplet<double>& t : triplets) {
    t = {t.row(), t.col(), t.value() * s.scale(t.row()) * s.scale(t.col())};
  }
  const Eigen::Index size = s.scale.size();
  s.matrix.resize(size, size);
  s.matrix.setFromTriplets(triplets.begin(), triplets.end());
  if (!s.ordered) {
    s.factor.analyzePattern(s.matrix);
    s.factor.setShift(kShift);
    s.ordered = true;
  }
  s.factor.factorize(s.matrix);
  if (s.factor.info() != Eigen::Success) {
    s.least = 0.0;
    s.mode = Eigen::VectorXd::Zero(size);
    return false;
  }
  s.findLeast();
  return s.least > kSingular;
}

std::vector<Six> FrameSolver::solve(const std::vector<Six>& loads) const {
  const State& s = *state_;
  const Eigen::Index size = s.scale.size();
  Eigen::VectorXd right(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    right(i) = loads[static_cast<std::size_t>(i / 6)][static_cast<std::size_t>(i % 6)] * s.scale(i);
  }
  Eigen::VectorXd x = s.factor.solve(right);
  Eigen::VectorXd rest = right - s.times(x);
  double residual = rest.norm();
  for (int step = 0; step < kRefinements && residual > kResidual * right.norm(); ++step) {
    x += s.factor.solve(rest);
    rest = right - s.times(x);
    const double before = std::exchange(residual, rest.norm());
    if (residual > kWorthwhile * before) {
      break;
    }
  }
  std::vector<Six> result(loads.size());
  for (Eigen::Index i = 0; i < size; ++i) {
    result[static_cast<std::size_t>(i / 6)][static_cast<std::size_t>(i % 6)] = x(i) * s.scale(i);
  }
  return result;
}

std::vector<Six> FrameSolver::motion() const {
  const State& s = *state_;
  std::vector<Six> result(s.frame->nodes.size());
  double greatest = 0.0;
  for (std::size_t node = 0; node < result.size(); ++node) {
    for (std::size_t k = 0; k < 6; ++k) {
      const auto i = static_cast<Eigen::Index>(6 * node + k);
      result[node][k] = s.mode(i) * s.scale(i);
    }
    const Six& r = result[node];
    greatest = std::max(greatest, lattice::length(Vec3{r[0], r[1], r[2]}));
  }
  for (Six& r : result) {
    for (double& value : r) {
      value = greatest > 0.0 ? value / greatest : 0.0;
    }
  }
  return result;
}

}  // namespace liftarm::analysis
