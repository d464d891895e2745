// Tests of null vectors: residuals of the equalities, and doubles against extended precision.
#include "solvers/rays/null_vector.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace kusabi::rays {
namespace {

// k x n of rank n - 1 with a null vector of numbers from 10^-spread to 1, all positive.
LongMatrix random_equalities(Eigen::Index rows, Eigen::Index columns, double spread,
                             std::mt19937& random) {
  std::uniform_real_distribution<double> number(-1, 1);
  const auto any = [&](auto...) { return static_cast<long double>(number(random)); };
  LongVector null(columns);
  for (auto& entry : null) entry = std::pow(10.0L, spread * (any() - 1) / 2);
  LongMatrix free = LongMatrix::NullaryExpr(columns - 1, columns, any);
  free -= (free * null) * null.transpose() / null.squaredNorm();
  LongMatrix all = LongMatrix::NullaryExpr(rows, columns - 1, any) * free;
  for (auto row : all.rowwise()) row /= row.lpNorm<Eigen::Infinity>();
  return all;
}

TEST(NullVector, SatisfiesTheEqualities) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const int columns = 2 + trial % 20;
    const auto all = random_equalities(columns - 1 + trial % 3, columns, 2, random);
    const LongVector x = null_vector(all);
    EXPECT_NEAR(static_cast<double>(x.sum()), 1, 1e-15);
    EXPECT_LT((all * x).cwiseAbs().maxCoeff(), 1e-17L * columns * x.cwiseAbs().maxCoeff());
  }
}

TEST(NullVector, InDoublesHasTheDigitsOfADouble) {
  std::mt19937 random(2);
  int not_to_the_last_digit = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const int columns = 2 + trial % 20;
    const auto all = random_equalities(columns - 1, columns, trial % 6, random);
    const auto rounded = rounded_null_vector(all, all.cast<double>());
    ASSERT_TRUE(rounded.has_value());
    const LongVector x = null_vector(all);
    const auto error = (rounded->cast<long double>() - x).cwiseAbs().cwiseQuotient(x.cwiseAbs());
    // where extended precision has lost some digits, too
    EXPECT_LT(error.maxCoeff(), 1e-11L) << trial;
    if (error.maxCoeff() > 1e-15L) ++not_to_the_last_digit;
  }
  EXPECT_LT(not_to_the_last_digit, 50);  // elimination in doubles alone would fail on nearly all
}

TEST(NullVector, InDoublesIsRefusedIfIllConditioned) {
  LongMatrix nearly_alike(2, 3);
  nearly_alike << 1, -1, 1, 1, -1, 1 - 1e-17L;
  EXPECT_FALSE(rounded_null_vector(nearly_alike, nearly_alike.cast<double>()).has_value());
}

}  // namespace
}  // namespace kusabi::rays
