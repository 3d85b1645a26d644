#include "analysis/rank.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "base/check.h"

namespace liftarm::analysis {

namespace {

// Norms that agree to this share are a tie, which the smaller index wins.
constexpr double kTie = 1.0 + 1e-9;
constexpr double kZero = 1e-9;  // entries of null vectors below are rounding

double dot(const double* a, const double* b, std::size_t n) {
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    sum += a[i] * b[i];
  }
  return sum;
}

//! Orthogonalises columns one by one and remembers how each was made up of those taken before.
class Orthogonaliser {
 public:
  explicit Orthogonaliser(const ColumnMatrix& matrix)
      : work_(matrix),
        squares_(matrix.columns()),
        shares_(matrix.columns()),
        taken_(matrix.columns(), false) {
    for (std::size_t j = 0; j < matrix.columns(); ++j) {
      updateSquare(j);
    }
  }

  //! Takes columns of the given ones, furthest first, until the rest depends on those taken.
  void takeFurthest(const std::vector<std::size_t>& candidates) {
    for (;;) {
      double best = kDependent * kDependent;
      std::size_t found = none();
      for (const std::size_t j : candidates) {
        if (!taken_[j] && squares_[j] > best * (found == none() ? 1.0 : kTie)) {
          best = squares_[j];
          found = j;
        }
      }
      if (found == none()) {
        return;
      }
      take(found);
    }
  }

  [[nodiscard]] bool taken(std::size_t j) const { return taken_[j]; }

  [[nodiscard]] std::size_t rank() const { return order_.size(); }

  //! The taken columns' multiples whose sum is nearest to a vector with the given shares.
  [[nodiscard]] std::vector<double> backSolve(const std::vector<double>& shares) const {
    std::vector<double> result(work_.columns(), 0.0);
    for (std::size_t k = shares.size(); k-- > 0;) {
      double value = shares[k];
      for (std::size_t l = k + 1; l < shares.size(); ++l) {
        value -= shares_[order_[l]][k] * result[order_[l]];
      }
      result[order_[k]] = value / lengths_[k];
    }
    return result;
  }

  //! What column j is made up of, one share per taken column.
  [[nodiscard]] const std::vector<double>& shares(std::size_t j) const { return shares_[j]; }

  [[nodiscard]] std::vector<double> sharesOf(std::vector<double> vector) const {
    std::vector<double> result;
    for (const std::size_t k : order_) {
      const double* direction = work_.column(k);
      const double share = dot(direction, vector.data(), vector.size());
      for (std::size_t i = 0; i < vector.size(); ++i) {
        vector[i] -= share * direction[i];
      }
      result.push_back(share);
    }
    return result;
  }

 private:
  static std::size_t none() { return std::numeric_limits<std::size_t>::max(); }

  void updateSquare(std::size_t j) {
    squares_[j] = dot(work_.column(j), work_.column(j), work_.rows());
  }

  void take(std::size_t pivot) {
    double* direction = work_.column(pivot);
    const double length = std::sqrt(squares_[pivot]);
    for (std::size_t i = 0; i < work_.rows(); ++i) {
      direction[i] /= length;
    }
    taken_[pivot] = true;
    order_.push_back(pivot);
    lengths_.push_back(length);
    for (std::size_t j = 0; j < work_.columns(); ++j) {
      if (!taken_[j]) {
        double* column = work_.column(j);
        const double share = dot(direction, column, work_.rows());
        shares_[j].push_back(share);
        if (share != 0.0) {
          for (std::size_t i = 0; i < work_.rows(); ++i) {
            column[i] -= share * direction[i];
          }
          updateSquare(j);
        }
      }
    }
  }

  ColumnMatrix work_;
  std::vector<double> squares_;              // of what is left of each column
  std::vector<std::vector<double>> shares_;  // along the directions taken while it was not
  std::vector<bool> taken_;
  std::vector<std::size_t> order_;
  std::vector<double> lengths_;
};

}  // namespace

NullBasis findNullBasis(const ColumnMatrix& matrix, const std::vector<int>& lateness) {
  LIFTARM_CHECK(lateness.size() == matrix.columns(), "one lateness per column");
  Orthogonaliser columns(matrix);
  std::vector<std::size_t> early;
  std::vector<std::size_t> late;
  for (std::size_t j = 0; j < matrix.columns(); ++j) {
    (lateness[j] == 0 ? early : late).push_back(j);
  }
  std::stable_sort(late.begin(), late.end(), [&](std::size_t a, std::size_t b) {
    return lateness[a] < lateness[b];
  });
  columns.takeFurthest(early);
  for (const std::size_t j : late) {
    columns.takeFurthest({j});
  }
  NullBasis basis;
  basis.rank = columns.rank();
  early.insert(early.end(), late.begin(), late.end());
  for (const std::size_t j : early) {
    if (columns.taken(j)) {
      continue;
    }
    std::vector<double> vector = columns.backSolve(columns.shares(j));
    for (double& value : vector) {
      value = std::abs(value) < kZero ? 0.0 : -value;
    }
    vector[j] = 1.0;
    basis.free.push_back(j);
    basis.vectors.push_back(std::move(vector));
  }
  return basis;
}

std::vector<double> solveNearest(const ColumnMatrix& matrix, const std::vector<double>& right) {
  LIFTARM_CHECK(right.size() == matrix.rows(), "one number per row");
  Orthogonaliser columns(matrix);
  std::vector<std::size_t> all(matrix.columns());
  for (std::size_t j = 0; j < all.size(); ++j) {
    all[j] = j;
  }
  columns.takeFurthest(all);
  return columns.backSolve(columns.sharesOf(right));
}

}  // namespace liftarm::analysis
