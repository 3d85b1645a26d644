#include "sketch/snap_solver.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/index.h"

namespace liftarm::sketch {

namespace {

using base::at;

constexpr double kConverged = 1e-11;
constexpr int kMaxSteps = 16;
constexpr int kMaxGradientSteps = 600;
constexpr double kSnapDamping = 1e-9;
constexpr double kGradientTolerance = 1e-7;  // relative; the next step takes care of the rest
constexpr double kMaxStep = 0.05;            // modules a value may move in one step
constexpr double kMaxMove = 0.25;            // modules a value may move in all
constexpr double kWorthwhile = 0.999;  // a step must bring the squared residual below this share

//! Sparse rows over the free values, row by row.
struct Jacobian {
  std::vector<std::size_t> start{0};
  std::vector<int> column;
  std::vector<double> coefficient;
  std::vector<double> residual;

  [[nodiscard]] std::size_t rows() const { return residual.size(); }

  void add(const SnapSystem& system, int variable, double value) {
    if (system.held[at(variable)] == 0 && value != 0.0) {
      column.push_back(variable);
      coefficient.push_back(value);
    }
  }

  //! Ends a row; one without free values is dropped, because nothing can be done about it.
  void finishRow(double rowResidual) {
    if (column.size() > start.back()) {
      start.push_back(column.size());
      residual.push_back(rowResidual);
    }
  }
};

double difference(const SnapSystem& system, const LengthRow& row, std::size_t axis) {
  return system.values[at(row.to[axis])] - system.values[at(row.from[axis])];
}

double distance(const SnapSystem& system, const LengthRow& row) {
  const double x = difference(system, row, 0);
  const double y = difference(system, row, 1);
  const double z = difference(system, row, 2);
  return std::sqrt(x * x + y * y + z * z);
}

Jacobian linearize(const SnapSystem& system) {
  Jacobian jacobian;
  for (const LengthRow& row : system.lengths) {
    const double now = distance(system, row);
    for (std::size_t axis = 0; axis < 3 && now > 0.0; ++axis) {
      if (row.from[axis] != row.to[axis]) {
        const double slope = difference(system, row, axis) / now;
        jacobian.add(system, row.to[axis], slope);
        jacobian.add(system, row.from[axis], -slope);
      }
    }
    jacobian.finishRow(now - row.length);
  }
  for (const LinearRow& row : system.linear) {
    for (const auto& [variable, coefficient] : row.terms) {
      jacobian.add(system, variable, coefficient);
    }
    jacobian.finishRow(residualOf(system, row));
  }
  return jacobian;
}

//! step = J^T * weights
void multiplyTransposed(const Jacobian& jacobian,
                        const std::vector<double>& weights,
                        std::vector<double>& step) {
  std::fill(step.begin(), step.end(), 0.0);
  for (std::size_t r = 0; r < jacobian.rows(); ++r) {
    for (std::size_t k = jacobian.start[r]; k < jacobian.start[r + 1]; ++k) {
      step[at(jacobian.column[k])] += jacobian.coefficient[k] * weights[r];
    }
  }
}

//! result = (J J^T + damping) * weights; `scratch` has one entry for each variable.
void multiplyNormal(const Jacobian& jacobian,
                    const std::vector<double>& weights,
                    std::vector<double>& scratch,
                    std::vector<double>& result) {
  multiplyTransposed(jacobian, weights, scratch);
  for (std::size_t r = 0; r < jacobian.rows(); ++r) {
    double sum = kSnapDamping * weights[r];
    for (std::size_t k = jacobian.start[r]; k < jacobian.start[r + 1]; ++k) {
      sum += jacobian.coefficient[k] * scratch[at(jacobian.column[k])];
    }
    result[r] = sum;
  }
}

double dotProduct(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += a[i] * b[i];
  }
  return sum;
}

//! The least-norm step that cancels the residuals to first order.
std::vector<double> leastNormStep(SnapSystem& system, const Jacobian& jacobian) {
  const std::size_t rows = jacobian.rows();
  std::vector<double> weights(rows, 0.0);
  std::vector<double> remaining = jacobian.residual;
  std::vector<double> search = remaining;
  std::vector<double> image(rows, 0.0);
  std::vector<double> step(system.values.size(), 0.0);
  double norm = dotProduct(remaining, remaining);
  const double enough = norm * kGradientTolerance * kGradientTolerance;
  const auto work = static_cast<std::int64_t>(2 * jacobian.column.size() + system.values.size());
  for (int i = 0; i < kMaxGradientSteps && norm > enough && system.workLeft > 0; ++i) {
    system.workLeft -= work;
    multiplyNormal(jacobian, search, step, image);
    const double curvature = dotProduct(search, image);
    if (!(curvature > 0.0)) {
      break;
    }
    const double share = norm / curvature;
    for (std::size_t r = 0; r < rows; ++r) {
      weights[r] += share * search[r];
      remaining[r] -= share * image[r];
    }
    const double next = dotProduct(remaining, remaining);
    const double keep = next / norm;
    for (std::size_t r = 0; r < rows; ++r) {
      search[r] = remaining[r] + keep * search[r];
    }
    norm = next;
  }
  multiplyTransposed(jacobian, weights, step);
  return step;
}

double squaredResiduals(const SnapSystem& system) {
  double sum = 0.0;
  for (const LengthRow& row : system.lengths) {
    const double residual = residualOf(system, row);
    sum += residual * residual;
  }
  for (const LinearRow& row : system.linear) {
    const double residual = residualOf(system, row);
    sum += residual * residual;
  }
  return sum;
}

//! \return False when the step would carry a value too far from where it began.
bool applyStep(SnapSystem& system,
               const std::vector<double>& step,
               const std::vector<double>& begin) {
  double largest = 0.0;
  for (const double value : step) {
    largest = std::max(largest, std::abs(value));
  }
  const double scale = largest > kMaxStep ? kMaxStep / largest : 1.0;
  for (std::size_t i = 0; i < step.size(); ++i) {
    system.values[i] -= scale * step[i];
    if (std::abs(system.values[i] - begin[i]) > kMaxMove) {
      return false;
    }
  }
  return true;
}

}  // namespace

double residualOf(const SnapSystem& system, const LengthRow& row) {
  return distance(system, row) - row.length;
}

double residualOf(const SnapSystem& system, const LinearRow& row) {
  double sum = 0.0;
  for (const auto& [variable, coefficient] : row.terms) {
    sum += coefficient * system.values[at(variable)];
  }
  return sum;
}

double largestLengthResidual(const SnapSystem& system) {
  double largest = 0.0;
  for (const LengthRow& row : system.lengths) {
    largest = std::max(largest, std::abs(residualOf(system, row)));
  }
  return largest;
}

double largestLinearResidual(const SnapSystem& system) {
  double largest = 0.0;
  for (const LinearRow& row : system.linear) {
    largest = std::max(largest, std::abs(residualOf(system, row)));
  }
  return largest;
}

void solveSnapSystem(SnapSystem& system) {
  const std::vector<double> begin = system.values;
  std::vector<double> best = begin;
  double bestSum = squaredResiduals(system);
  for (int i = 0; i < kMaxSteps && system.workLeft > 0; ++i) {
    if (std::max(largestLengthResidual(system), largestLinearResidual(system)) <= kConverged) {
      return;
    }
    const Jacobian jacobian = linearize(system);
    if (jacobian.rows() == 0 || !applyStep(system, leastNormStep(system, jacobian), begin)) {
      break;
    }
    const double sum = squaredResiduals(system);
    if (!(sum < kWorthwhile * bestSum)) {
      break;
    }
    bestSum = sum;
    best = system.values;
  }
  system.values = std::move(best);
}

}  // namespace liftarm::sketch
