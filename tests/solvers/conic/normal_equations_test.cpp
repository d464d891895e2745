// Tests of the small dense kernels against Eigen, at every size up to the largest: products with
// padded columns, the rank update, and Cholesky factorisation with appended right sides.
#include "solvers/conic/normal_equations.hpp"

#include <limits>
#include <utility>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "solvers/conic/pack.hpp"

namespace kusabi::conic {
namespace {

constexpr int largest_size = 64;

// Sums of at most 200 products of order one.
constexpr double rounding = 1000 * std::numeric_limits<double>::epsilon();

// Padded columns of random numbers, and the same without the padding.
struct Sample {
  Sample(int rows, int components, int count)
      : padded_matrix(Eigen::MatrixXd::Zero(padded(rows), components * padded(count))),
        matrix(Eigen::MatrixXd::Random(rows, components * count)),
        columns{padded_matrix.data(), padded(rows), components, count, padded(count)} {
    for (int d = 0; d < components; ++d)
      padded_matrix.block(0, d * columns.stride, rows, count) = matrix.middleCols(d * count, count);
  }

  Eigen::MatrixXd padded_matrix, matrix;
  PackedColumns columns;
};

Eigen::VectorXd random_padded(int size) {
  Eigen::VectorXd numbers = Eigen::VectorXd::Zero(padded(size));
  numbers.head(size).setRandom();
  return numbers;
}

TEST(PackedColumns, ProductsAreThoseOfTheMatrix) {
  for (int rows = 1; rows <= largest_size; ++rows) {
    const int count = 1 + rows * 7 % 30;
    const Sample sample(rows, 3, count);
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

TEST(NormalEquations, AreSolvedForAllRightSides) {
  for (int rows = 1; rows <= largest_size; ++rows) {
    const Sample sample(rows, 2, rows);
    NormalEquations equations(rows);
    equations.assemble(sample.columns);
    Eigen::MatrixXd dense = sample.matrix * sample.matrix.transpose();
    for (int i = 0; i < rows; ++i) {
      EXPECT_NEAR(equations.diagonal(i), dense(i, i), rounding * dense(i, i));
      equations.add_to_diagonal(i, 1 + i);
      dense(i, i) += 1 + i;
    }
    const Eigen::VectorXd first = random_padded(rows), second = random_padded(rows),
                          third = random_padded(rows);
    Eigen::VectorXd x = first, y = second, z = third;
    ASSERT_TRUE(equations.factorise(x.data(), y.data()));
    equations.solve(z.data());
    for (const auto& [solution, right_side] : {std::pair(x, first), {y, second}, {z, third}}) {
      EXPECT_LE((dense * solution.head(rows) - right_side.head(rows)).norm(),
                rounding * dense.norm() * solution.norm());
      EXPECT_EQ(solution.tail(solution.size() - rows).norm(), 0);
    }
  }
}

TEST(NormalEquations, RefuseAPivotThatIsNotPositive) {
  for (const int last : {1, 2, 5, 8}) {
    const Sample sample(last, 1, last);
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
