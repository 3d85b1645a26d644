#pragma once

#include <cstddef>
#include <vector>

namespace liftarm::analysis {

//! \brief A dense matrix stored column after column.
class ColumnMatrix {
 public:
  ColumnMatrix(std::size_t rows, std::size_t columns)
      : rows_(rows), columns_(columns), data_(rows * columns, 0.0) {}

  [[nodiscard]] std::size_t rows() const { return rows_; }

  [[nodiscard]] std::size_t columns() const { return columns_; }

  [[nodiscard]] double* column(std::size_t j) { return data_.data() + j * rows_; }

  [[nodiscard]] const double* column(std::size_t j) const { return data_.data() + j * rows_; }

 private:
  std::size_t rows_;
  std::size_t columns_;
  std::vector<double> data_;
};

//! A column that lies nearer than this to the span of others depends on them. Columns are of the
//! order of one. Coordinates in files are rounded to 1e-6, and lengths on the lattice are far
//! above.
inline constexpr double kDependent = 5e-5;

//! \brief The null space of a matrix, one vector for each column that depends on those before it.
struct NullBasis {
  std::size_t rank = 0;
  std::vector<std::size_t> free;             //!< the dependent columns, in rising order of lateness
  std::vector<std::vector<double>> vectors;  //!< vectors[i]: 1 in free[i], 0 in the other free ones
};

//! \brief Finds the null space by column-pivoted orthogonalisation (modified Gram-Schmidt).
//! \details Columns of lateness 0 come first, the one that is furthest from the span of those taken
//! before it foremost; then the others by rising lateness, one by one. So the latest columns end up
//! free where they can, and each vector is the smallest set of columns that depend on each other
//! with its free one. Only + - * / and square roots in a fixed order: the same bits on every
//! platform. \param lateness One number per column, not negative.
NullBasis findNullBasis(const ColumnMatrix& matrix, const std::vector<int>& lateness);

//! \brief x that brings matrix * x nearest to `right`; columns that depend on others get 0.
std::vector<double> solveNearest(const ColumnMatrix& matrix, const std::vector<double>& right);

}  // namespace liftarm::analysis
