#include "analysis/rank_sparse.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace liftarm::analysis {

namespace {

constexpr double kSure = 20 * kDependent;  // the smallest pivot that leaves no doubt
constexpr double kGrown = 1e5;             // entries start at the order of one
constexpr double kShareOfLargest = 0.1;    // a pivot is at least this share of its column's largest
constexpr double kNothing = 1e-9;
constexpr std::size_t kFewColumns = 100;  // orthogonalisation is fast enough

using Entry = std::pair<std::size_t, double>;  // column, value
using Row = std::vector<Entry>;                // by column

class Elimination {
 public:
  Elimination(const ColumnMatrix& matrix, const std::vector<int>& lateness)
      : rows_(matrix.rows()),
        done_(matrix.rows(), false),
        rowsOf_(matrix.columns()),
        state_(matrix.columns(), State::kActive),
        lateness_(lateness) {
    for (std::size_t j = 0; j < matrix.columns(); ++j) {
      const double* column = matrix.column(j);
      for (std::size_t i = 0; i < matrix.rows(); ++i) {
        if (column[i] != 0.0) {
          rows_[i].emplace_back(j, column[i]);
          rowsOf_[j].push_back(i);
        }
      }
    }
  }

  //! \return False where rounding might count.
  bool run() {
    for (;;) {
      const std::size_t column = nextColumn();
      if (column == rowsOf_.size()) {
        return true;
      }
      if (!pivotOn(column)) {
        return false;
      }
    }
  }

  [[nodiscard]] NullBasis basis() const {
    NullBasis result;
    result.rank = pivots_.size();
    for (std::size_t j = 0; j < state_.size(); ++j) {
      if (state_[j] == State::kFree) {
        result.free.push_back(j);
      }
    }
    std::stable_sort(result.free.begin(), result.free.end(), [&](std::size_t a, std::size_t b) {
      return lateness_[a] < lateness_[b];
    });
    for (const std::size_t j : result.free) {
      result.vectors.push_back(vectorOf(j));
    }
    return result;
  }

 private:
  enum class State { kActive, kPivot, kFree };

  //! Of the least late active columns the one with the fewest rows.
  [[nodiscard]] std::size_t nextColumn() const {
    std::size_t best = rowsOf_.size();
    for (std::size_t j = 0; j < rowsOf_.size(); ++j) {
      if (state_[j] == State::kActive &&
          (best == rowsOf_.size() || std::pair(lateness_[j], rowsOf_[j].size()) <
                                         std::pair(lateness_[best], rowsOf_[best].size()))) {
        best = j;
      }
    }
    return best;
  }

  [[nodiscard]] double valueAt(std::size_t row, std::size_t column) const {
    const auto found = std::lower_bound(
        rows_[row].begin(), rows_[row].end(), column, [](const Entry& e, std::size_t c) {
          return e.first < c;
        });
    return found != rows_[row].end() && found->first == column ? found->second : 0.0;
  }

  bool pivotOn(std::size_t column) {
    std::vector<std::size_t> rows;
    double largest = 0.0;
    for (const std::size_t row : rowsOf_[column]) {
      const double value = std::abs(valueAt(row, column));
      if (!done_[row] && value > 0.0) {
        rows.push_back(row);
        largest = std::max(largest, value);
      }
    }
    if (largest <= kDependent) {
      state_[column] = State::kFree;
      return true;
    }
    std::size_t pivot = std::numeric_limits<std::size_t>::max();
    for (const std::size_t row : rows) {
      const bool large = std::abs(valueAt(row, column)) >= kShareOfLargest * largest;
      if (large && (pivot == std::numeric_limits<std::size_t>::max() ||
                    rows_[row].size() < rows_[pivot].size())) {
        pivot = row;
      }
    }
    const double value = valueAt(pivot, column);
    bool sure = std::abs(value) >= kSure;
    done_[pivot] = true;
    state_[column] = State::kPivot;
    pivots_.emplace_back(pivot, column);
    for (const std::size_t row : rows) {
      if (row != pivot) {
        sure = subtract(row, pivot, valueAt(row, column) / value, column) && sure;
      }
    }
    return sure;
  }

  //! row -= share * pivot row, without the pivot's column. \return Whether no entry grew too large.
  bool subtract(std::size_t row, std::size_t pivot, double share, std::size_t column) {
    Row result;
    bool small = true;
    const Row& a = rows_[row];
    const Row& b = rows_[pivot];
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.size() || j < b.size()) {
      const bool fromA = j == b.size() || (i < a.size() && a[i].first <= b[j].first);
      const bool fromB = i == a.size() || (j < b.size() && b[j].first <= a[i].first);
      const std::size_t c = fromA ? a[i].first : b[j].first;
      const double value = (fromA ? a[i].second : 0.0) - (fromB ? share * b[j].second : 0.0);
      if (c != column && std::abs(value) > kNothing) {
        result.emplace_back(c, value);
        small = small && std::abs(value) < kGrown;
        if (!fromA) {
          rowsOf_[c].push_back(row);
        }
      }
      i += fromA ? 1 : 0;
      j += fromB ? 1 : 0;
    }
    rows_[row] = std::move(result);
    return small;
  }

  //! Pivots backwards: each row gives its pivot's column from those that were eliminated after it.
  [[nodiscard]] std::vector<double> vectorOf(std::size_t free) const {
    std::vector<double> x(state_.size(), 0.0);
    x[free] = 1.0;
    for (std::size_t p = pivots_.size(); p-- > 0;) {
      const auto& [row, column] = pivots_[p];
      double sum = 0.0;
      double own = 1.0;
      for (const auto& [c, value] : rows_[row]) {
        if (c == column) {
          own = value;
        } else {
          sum += value * x[c];
        }
      }
      const double value = -sum / own;
      x[column] = std::abs(value) < kNothing ? 0.0 : value;
    }
    return x;
  }

  std::vector<Row> rows_;
  std::vector<bool> done_;                        // rows that were pivots
  std::vector<std::vector<std::size_t>> rowsOf_;  // per column; may name rows that lost it
  std::vector<State> state_;
  const std::vector<int>& lateness_;
  std::vector<std::pair<std::size_t, std::size_t>> pivots_;  // row, column, in order
};

}  // namespace

std::optional<NullBasis> eliminateSparse(const ColumnMatrix& matrix,
                                         const std::vector<int>& lateness) {
  Elimination elimination(matrix, lateness);
  if (!elimination.run()) {
    return std::nullopt;
  }
  return elimination.basis();
}

NullBasis findNullBasisOfAny(const ColumnMatrix& matrix, const std::vector<int>& lateness) {
  if (matrix.columns() > kFewColumns) {
    if (std::optional<NullBasis> basis = eliminateSparse(matrix, lateness); basis.has_value()) {
      return *std::move(basis);
    }
  }
  return findNullBasis(matrix, lateness);
}

}  // namespace liftarm::analysis
