// Factors of both libraries compared with dense matrices: grids, separate parts, and matrices that
// no order changes.
#include "problems/structure/factor/sparse_factor.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <random>
#include <vector>

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include "dense.hpp"
#include "problems/structure/factor/blas_product.hpp"
#include "problems/wedged/stiffness_factor.hpp"

namespace kusabi::problems {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// Random coupling of all unknowns of neighbouring nodes of a grid, with eigenvalues of at least
/// `minimum`.
Sparse grid(int along, int across, int up, int unknowns, double minimum = 1) {
  std::mt19937 bits(5);  // NOLINT(cert-msc32-c,cert-msc51-cpp): repeatable on purpose
  const int nodes = along * across * up;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd sums = Eigen::VectorXd::Constant(nodes * unknowns, minimum);
  const auto couple = [&](int a, int b) {
    const double entry = static_cast<double>(bits()) * 0x1p-31 - 1;
    entries.emplace_back(a, b, entry);
    entries.emplace_back(b, a, entry);
    sums(a) += std::abs(entry);
    sums(b) += std::abs(entry);
  };
  const auto near = [&](int a, int b) {
    return std::abs(a % along - b % along) < 2 &&
           std::abs(a / along % across - b / along % across) < 2 &&
           std::abs(a / along / across - b / along / across) < 2;
  };
  for (int a = 0; a < nodes; ++a) {
    const int first = std::max(0, a - along * across - along - 1);
    for (int b = first; b <= a; ++b) {
      if (!near(a, b)) continue;
      for (int i = 0; i < unknowns; ++i)
        for (int j = 0; j < (a == b ? i : unknowns); ++j)
          couple(a * unknowns + i, b * unknowns + j);
    }
  }
  for (int i = 0; i < nodes * unknowns; ++i) entries.emplace_back(i, i, sums(i));
  Sparse matrix(nodes * unknowns, nodes * unknowns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

template <class Real>
void expect_solutions(const Sparse& matrix, double shift) {
  const SparseFactor<Real> factor(matrix.cast<Real>(), Real(shift));
  ASSERT_TRUE(factor.exists());
  Sparse identity(matrix.rows(), matrix.cols());
  identity.setIdentity();
  const Eigen::SimplicialLLT<Sparse> expected(matrix + shift * identity);
  for (const Eigen::Index columns : {1, 3, 70}) {
    const Eigen::MatrixXd right = Eigen::MatrixXd::Random(matrix.rows(), columns);
    typename SparseFactor<Real>::Matrix solution = right.cast<Real>();
    factor.solve(solution);
    const Eigen::MatrixXd expected_solution = expected.solve(right);
    EXPECT_LE((solution.template cast<double>() - expected_solution).norm(),
              1e-12 * expected_solution.norm());
  }
}

TEST(SparseFactor, SolvesAsEigensFactorInDoubles) {
  for (const Sparse& matrix :
       {grid(1, 1, 1, 1), grid(2, 1, 1, 90), grid(40, 9, 1, 2), grid(7, 7, 7, 3)}) {
    expect_solutions<double>(matrix, 0);
    expect_solutions<double>(matrix, 0.5);
    expect_solutions<double>(matrix, -0.5);
  }
  expect_solutions<long double>(grid(40, 9, 1, 2), -0.5);
  expect_solutions<numbers::Precise>(grid(9, 9, 1, 2), -0.5);
}

TEST(SparseFactor, ExistsForAMatrixWithoutRows) {
  const SparseFactor<double> factor{Sparse(0, 0)};
  EXPECT_TRUE(factor.exists());
  EXPECT_EQ(factor.rows().maximum_entries, 0);
}

// I + 11' of several sizes, which no permutation of their rows changes, and a diagonal.
TEST(SparseFactor, HasTheRowsOfADenseFactor) {
  const std::vector<int> sizes{1, 3, 40, 200, 1, 70};
  int size = 0;
  double sum = 0;
  std::vector<Eigen::Triplet<double>> entries;
  for (const int own : sizes) {
    for (int i = 0; i < own; ++i)
      for (int j = 0; j < own; ++j) entries.emplace_back(size + i, size + j, i == j ? 2 : 1);
    size += own;
    Eigen::MatrixXd lower = Eigen::MatrixXd::Zero(own, own);
    for (int j = 0; j < own; ++j) {  // L_jj^2 = (j + 2)/(j + 1), the column below it is constant
      lower(j, j) = std::sqrt((j + 2.0) / (j + 1.0));
      for (int i = j + 1; i < own; ++i) lower(i, j) = lower(j, j) / (j + 2);
    }
    sum = std::max(sum, (lower * lower.transpose()).rowwise().sum().maxCoeff());
  }
  Sparse matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  for (const FactorRows& rows : {SparseFactor<double>(matrix).rows(),
                                 SparseFactor<long double>(matrix.cast<long double>()).rows()}) {
    EXPECT_NEAR(rows.maximum_sum, sum, 1e-9 * sum);
    EXPECT_EQ(rows.maximum_entries, 200);
  }
}

TEST(SparseFactor, ExistsForShiftsAboveTheNegativeLeastEigenvalue) {
  const Sparse matrix = grid(20, 5, 1, 2);
  const double least = dense::eigenvalues(Eigen::MatrixXd(matrix)).minCoeff();
  EXPECT_TRUE(SparseFactor<double>(matrix, -least * (1 - 1e-9)).exists());
  EXPECT_FALSE(SparseFactor<double>(matrix, -least * (1 + 1e-9)).exists());
}

// Proved bounds lie below the eigenvalue, by at most the choice of the shift.
TEST(StiffnessFactor, BoundsTheLeastEigenvalueFromBelow) {
  for (const double minimum : {1.0, 1e-4, 1e-8}) {
    const Sparse matrix = grid(30, 6, 1, 2, minimum);
    const double least = dense::eigenvalues(Eigen::MatrixXd(matrix)).minCoeff();
    const Eigen::SparseMatrix<numbers::Precise> precise = matrix.cast<numbers::Precise>();
    for (const double bound : {StiffnessFactor<double>(precise).min_eigenvalue(),
                               StiffnessFactor<long double>(precise).min_eigenvalue()}) {
      EXPECT_GT(bound, least / 5);
      EXPECT_LT(bound, least);
    }
  }
}

TEST(StiffnessFactor, ProvesNothingForSingularMatrices) {
  Sparse matrix = grid(30, 6, 1, 2);
  const double least = dense::eigenvalues(Eigen::MatrixXd(matrix)).minCoeff();
  for (int i = 0; i < matrix.rows(); ++i) matrix.coeffRef(i, i) -= least;
  const Eigen::SparseMatrix<numbers::Precise> precise = matrix.cast<numbers::Precise>();
  EXPECT_LE(StiffnessFactor<double>(precise).min_eigenvalue(), 1e-13);
}

TEST(BlasProduct, IsTheProductOfTheColumns) {
  const Eigen::MatrixXd a = Eigen::MatrixXd::Random(300, 7);
  const Eigen::MatrixXd b = Eigen::MatrixXd::Random(400, 50);
  const Eigen::MatrixXd expected = a.leftCols(5).transpose() * b.topRows(300);
  EXPECT_LE((product_of_columns(a.leftCols(5), b.topRows(300)) - expected).norm(), 1e-12);
}

// The ranks of a job share the cores.
TEST(SparseFactor, TakesOneThread) {
  const std::filesystem::path tasks("/proc/self/task");
  if (!std::filesystem::exists(tasks)) GTEST_SKIP() << "no list of threads";
  const Sparse matrix = grid(13, 13, 13, 3);
  const SparseFactor<double> factor(matrix);
  Eigen::MatrixXd right = Eigen::MatrixXd::Random(matrix.rows(), 64);
  factor.solve(right);
  const auto count = [&] {
    return std::distance(std::filesystem::directory_iterator(tasks),
                         std::filesystem::directory_iterator());
  };
  EXPECT_EQ(count(), 1);
}

}  // namespace
}  // namespace kusabi::problems
