#include "analysis/rank.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/rank_sparse.h"
#include "base/rng.h"

namespace liftarm::analysis {
namespace {

//! Columns of small whole numbers, the last `dependent` of them sums of two others.
ColumnMatrix matrixOf(std::size_t rows, std::size_t independent, std::size_t dependent) {
  base::Rng rng(7);
  ColumnMatrix matrix(rows, independent + dependent);
  for (std::size_t j = 0; j < independent; ++j) {
    matrix.column(j)[j] = 1.0 + static_cast<double>(rng.below(3));
    for (int k = 0; k < 3; ++k) {
      matrix.column(j)[rng.below(static_cast<std::uint32_t>(rows))] +=
          static_cast<double>(rng.below(3)) - 1.0;
    }
  }
  for (std::size_t j = 0; j < dependent; ++j) {
    const double* a = matrix.column(j);
    const double* b = matrix.column(independent - 1 - j);
    for (std::size_t i = 0; i < rows; ++i) {
      matrix.column(independent + j)[i] = a[i] + b[i];
    }
  }
  return matrix;
}

double residual(const ColumnMatrix& matrix, const std::vector<double>& x) {
  double largest = 0.0;
  for (std::size_t i = 0; i < matrix.rows(); ++i) {
    double sum = 0.0;
    for (std::size_t j = 0; j < matrix.columns(); ++j) {
      sum += matrix.column(j)[i] * x[j];
    }
    largest = std::max(largest, std::abs(sum));
  }
  return largest;
}

std::vector<int> noneLate(const ColumnMatrix& matrix) {
  return std::vector<int>(matrix.columns(), 0);
}

TEST(NullBasis, HasAVectorForEachDependentColumn) {
  const ColumnMatrix matrix = matrixOf(60, 40, 7);
  const NullBasis basis = findNullBasis(matrix, noneLate(matrix));
  EXPECT_EQ(basis.vectors.size(), 7U);
  EXPECT_EQ(basis.rank, 40U);
}

TEST(NullBasis, VectorsAreInTheNullSpace) {
  const ColumnMatrix matrix = matrixOf(60, 40, 7);
  for (const std::vector<double>& x : findNullBasis(matrix, noneLate(matrix)).vectors) {
    EXPECT_LT(residual(matrix, x), 1e-9);
  }
}

TEST(NullBasis, LateColumnIsFreeWhereItCanBe) {
  const ColumnMatrix matrix = matrixOf(60, 40, 7);
  std::vector<int> lateness = noneLate(matrix);
  lateness[3] = 1;  // part of a sum, so it may be the dependent one
  const NullBasis basis = findNullBasis(matrix, lateness);
  EXPECT_EQ(basis.free.back(), 3U);
}

TEST(NullBasis, EliminationFindsTheSameRank) {
  for (const std::size_t dependent : {0U, 1U, 20U}) {
    const ColumnMatrix matrix = matrixOf(200, 150, dependent);
    const auto basis = eliminateSparse(matrix, noneLate(matrix));
    ASSERT_TRUE(basis.has_value());
    EXPECT_EQ(basis->rank, findNullBasis(matrix, noneLate(matrix)).rank);
    EXPECT_EQ(basis->vectors.size(), dependent);
  }
}

TEST(NullBasis, EliminationFindsVectorsInTheNullSpace) {
  const ColumnMatrix matrix = matrixOf(200, 150, 20);
  const auto basis = eliminateSparse(matrix, noneLate(matrix));
  ASSERT_TRUE(basis.has_value());
  for (const std::vector<double>& x : basis->vectors) {
    EXPECT_LT(residual(matrix, x), 1e-9);
  }
}

TEST(NullBasis, EliminationFreesLateColumnsToo) {
  const ColumnMatrix matrix = matrixOf(200, 150, 20);
  std::vector<int> lateness = noneLate(matrix);
  lateness[3] = 1;
  const auto basis = eliminateSparse(matrix, lateness);
  ASSERT_TRUE(basis.has_value());
  EXPECT_EQ(basis->free.back(), 3U);
}

TEST(NullBasis, EliminationRefusesPivotsNearTheThreshold) {
  ColumnMatrix matrix(2, 2);
  matrix.column(0)[0] = 1.0;
  matrix.column(1)[0] = 1.0;
  matrix.column(1)[1] = 3 * kDependent;
  EXPECT_FALSE(eliminateSparse(matrix, {0, 0}).has_value());
  EXPECT_EQ(findNullBasis(matrix, {0, 0}).rank, 2U);
}

TEST(SolveNearest, SolvesAnOverdeterminedSystemExactlyWhereThatCanBe) {
  const ColumnMatrix matrix = matrixOf(60, 40, 0);
  std::vector<double> right(60, 0.0);
  for (std::size_t j = 0; j < 40; ++j) {
    for (std::size_t i = 0; i < 60; ++i) {
      right[i] += static_cast<double>(j) * matrix.column(j)[i];
    }
  }
  const std::vector<double> x = solveNearest(matrix, right);
  for (std::size_t j = 0; j < 40; ++j) {
    EXPECT_NEAR(x[j], static_cast<double>(j), 1e-9);
  }
}

}  // namespace
}  // namespace liftarm::analysis
