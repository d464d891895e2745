// Tests of the small dense kernels against Eigen, at every size up to the largest: products with
// padded columns, the rank update, and Cholesky factorisation with appended right sides.
#include "solvers/conic/normal_equations.hpp"

#include <array>
#include <limits>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "solvers/conic/dense_product.hpp"
#include "solvers/conic/motions.hpp"
#include "solvers/conic/pack.hpp"

namespace kusabi::conic {
namespace {

constexpr int largest_size = 64;

// Sums of at most 200 products of order one.
constexpr double rounding = 1000 * std::numeric_limits<double>::epsilon();

// Padded columns of random numbers, and the same without the padding in doubles.
template <class Real = double>
struct Sample {
  Sample(int rows, int components, int count)
      : padded_matrix(MatrixOf<Real>::Zero(padded<Real>(rows), components * padded<Real>(count))),
        matrix(Eigen::MatrixXd::Random(rows, components * count)),
        columns{padded_matrix.data(), padded<Real>(rows), components, count, padded<Real>(count)} {
    for (int d = 0; d < components; ++d)
      padded_matrix.block(0, d * columns.stride, rows, count) =
          matrix.middleCols(d * count, count).template cast<Real>();
  }

  MatrixOf<Real> padded_matrix;
  Eigen::MatrixXd matrix;
  PackedColumns<Real> columns;
};

Eigen::VectorXd random_padded(int size) {
  Eigen::VectorXd numbers = Eigen::VectorXd::Zero(padded(size));
  numbers.head(size).setRandom();
  return numbers;
}

// Sizes around those of a block, and more columns than are copied at a time.
TEST(DenseProduct, IsThatOfTheMatrices) {
  for (const int rows : {1, 7, 8, 9, 33})
    for (const int columns : {1, 8, 19})
      for (const int depth : {0, 1, 128, 129, 300}) {
        const Eigen::MatrixXd a = Eigen::MatrixXd::Random(rows, depth);
        const Eigen::MatrixXd b = Eigen::MatrixXd::Random(columns, depth);
        const Eigen::MatrixXd product = product_with_transpose(a, b);
        ASSERT_EQ(product.rows(), rows);
        ASSERT_EQ(product.cols(), columns);
        EXPECT_LE((product - a * b.transpose()).norm(), rounding) << rows << ' ' << depth;
      }
}

TEST(PackedColumns, ProductsAreThoseOfTheMatrix) {
  for (int rows = 1; rows <= largest_size; ++rows) {
    const int count = 1 + rows * 7 % 30;
    const Sample<> sample(rows, 3, count);
    const Eigen::VectorXd weights = random_padded(rows);
    Eigen::VectorXd products(3 * sample.columns.stride);
    transposed_product(sample.columns, weights.data(), products.data());
    EXPECT_LE((products - sample.padded_matrix.transpose() * weights).norm(), rounding);

    Eigen::VectorXd sum(sample.columns.rows);
    const Eigen::VectorXd coefficients = Eigen::VectorXd::Random(products.size());
    product(sample.columns, coefficients.data(), sum.data());
    EXPECT_LE((sum - sample.padded_matrix * coefficients).norm(), rounding * count);
  }
}

template <class Real>
void expect_solutions(int rows) {
  const Sample<Real> sample(rows, 2, rows);
  NormalEquations<Real> equations(rows);
  equations.assemble(sample.columns);
  Eigen::MatrixXd dense = sample.matrix * sample.matrix.transpose();
  for (int i = 0; i < rows; ++i) {
    EXPECT_NEAR(numbers::rounded(equations.diagonal(i)), dense(i, i), rounding * dense(i, i));
    equations.add_to_diagonal(i, Real(1 + i));
    dense(i, i) += 1 + i;
  }
  std::array<Eigen::VectorXd, 3> right_sides;
  std::array<VectorOf<Real>, 3> solutions;
  for (std::size_t n = 0; n < solutions.size(); ++n) {
    right_sides[n] = Eigen::VectorXd::Zero(padded<Real>(rows));
    right_sides[n].head(rows).setRandom();
    solutions[n] = right_sides[n].template cast<Real>();
  }
  ASSERT_TRUE(equations.factorise(solutions[0].data(), solutions[1].data()));
  equations.solve(solutions[2].data());
  for (std::size_t n = 0; n < solutions.size(); ++n) {
    const Eigen::VectorXd solution = solutions[n].template cast<double>();
    EXPECT_LE((dense * solution.head(rows) - right_sides[n].head(rows)).norm(),
              rounding * dense.norm() * solution.norm());
    EXPECT_EQ(solution.tail(solution.size() - rows).norm(), 0);
  }
}

TEST(NormalEquations, AreSolvedForAllRightSides) {
  for (int rows = 1; rows <= largest_size; ++rows) expect_solutions<double>(rows);
}

// Their columns are copied by blocks, the last of which is smaller.
TEST(NormalEquations, AreSolvedWithManyRows) {
  for (const int rows : {130, 259}) expect_solutions<double>(rows);
}

TEST(NormalEquations, AreSolvedInExtendedPrecision) {
  for (const int rows : {1, 2, 3, 7, 31, 50, 131}) {
    expect_solutions<long double>(rows);
    expect_solutions<numbers::Precise>(rows);
  }
}

TEST(NormalEquations, RefuseAPivotThatIsNotPositive) {
  for (const int last : {1, 2, 5, 8}) {
    const Sample<> sample(last, 1, last);
    NormalEquations equations(last);
    equations.assemble(sample.columns);
    equations.add_to_diagonal(last - 1, -2 * equations.diagonal(last - 1));
    Eigen::VectorXd x = random_padded(last), y = x;
    EXPECT_FALSE(equations.factorise(x.data(), y.data()));
    equations.assemble(sample.columns);
    equations.add_to_diagonal(last - 1, std::numeric_limits<double>::quiet_NaN());
    EXPECT_FALSE(equations.factorise(x.data(), y.data()));
  }
}

}  // namespace
}  // namespace kusabi::conic
