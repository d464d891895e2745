// Combinations of columns with very different sizes, such as rigid-body modes with long levers.
#include "verify/arithmetic/least_squares.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace kusabi::verify {
namespace {

TEST(LeastSquares, FindsTheMotionOfALongLever) {
  // Two translations and a rotation in the plane, of three nodes about one that is far away.
  const std::vector<std::vector<double>> nodes{{0.86, -0.09}, {-0.35, -0.76}, {-0.74, 0.55}};
  const std::vector<double> far{8.8e6, -1.9e7};
  std::vector<double> matrix;
  for (const auto& node : nodes) {
    for (const double each : {1.0, 0.0, far[1] - node[1], 0.0, 1.0, node[0] - far[0]})
      matrix.push_back(each);
  }
  const std::vector<double> shares{5.7e6, 2.6e6, 0.3};
  std::vector<double> right;
  for (std::size_t row = 0; row < 6; ++row) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += matrix[3 * row + k] * shares[k];
    right.push_back(sum);
  }
  const auto found = LeastSquares(matrix, right.size()).solve(right);
  ASSERT_TRUE(found);
  // Rounding of products of the order of 6e6.
  for (std::size_t row = 0; row < 6; ++row) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += matrix[3 * row + k] * (*found)[k];
    EXPECT_NEAR(sum, right[row], 1e-8) << row;
  }
}

TEST(LeastSquares, HasTheLeastResidual) {
  const auto found = LeastSquares(std::vector{1.0, 0.0, 1.0, 1.0, 1.0, 2.0}, 3)
                         .solve(std::vector{0.0, 1.0, 1.0});  // a line through three points
  ASSERT_TRUE(found);
  EXPECT_NEAR((*found)[0], 1.0 / 6, 1e-15);
  EXPECT_NEAR((*found)[1], 0.5, 1e-15);
}

TEST(LeastSquares, RefusesAColumnOfZeros) {
  EXPECT_FALSE(LeastSquares(std::vector{1.0, 0.0, 2.0, 0.0}, 2).solve(std::vector{1.0, 1.0}));
}

}  // namespace
}  // namespace kusabi::verify
