// Exact answers of linear programs: those that doubles, or numbers rounded to fractions, get wrong.
#include "solvers/linear/exact_simplex.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solvers/linear/rational_factor.hpp"
#include "solvers/linear/safe_bound.hpp"

namespace kusabi::linear {
namespace {

using testing::ElementsAre;

// GLPK's basis in doubles, as the start.
ExactSolution solve_from_doubles(const LinearProgram& program) {
  Simplex doubles(program);
  doubles.solve_robustly();
  return solve_exactly(program, doubles.basis());
}

// x1 <= a x2 <= a^2 x3 ... <= a^4 x5, x5 <= 1; the largest x1.
LinearProgram chain(double a, double lower) {
  LinearProgram program;
  for (int j = 0; j < 5; ++j) program.add_column({.cost = j == 0 ? -1.0 : 0.0, .lower = lower});
  for (int j = 0; j < 4; ++j)
    program.add_row({.upper = 0}, std::vector<LinearTerm>{{j, 1}, {j + 1, -a}});
  program.add_row({.upper = 1}, std::vector<LinearTerm>{{4, 1}});
  return program;
}

// x + y is at least 1 and at most `most`.
LinearProgram pressed(double most) {
  LinearProgram program;
  program.add_column({.cost = 1, .upper = 10});
  program.add_column({.cost = 1, .upper = 10});
  program.add_column({.lower = 1e12, .upper = 1e12});
  program.add_row({.lower = 1}, std::vector<LinearTerm>{{0, 1}, {1, 1}});
  program.add_row({.upper = most}, std::vector<LinearTerm>{{0, 1}, {1, 1}});
  return program;
}

TEST(ExactSimplex, FindsAnOptimumFarFromAllCoefficients) {
  for (const double lower : {0.0, -infinity}) {
    const auto found = solve_from_doubles(chain(1e7, lower));
    ASSERT_EQ(found.status, LinearStatus::optimal);
    EXPECT_EQ(found.objective, -1e28);
    EXPECT_LE(found.bound, -1e28);
    EXPECT_EQ(found.values[3], 1e7);
  }
}

TEST(ExactSimplex, TakesNumbersAsTheyAre) {
  // GLPK's exact method takes 0.99999999999 as 1 unless all numbers are integers.
  for (const int cheaper : {0, 1}) {
    auto program = pressed(2);
    program.columns[static_cast<std::size_t>(cheaper)].cost = 0.99999999999;
    const auto cheapest = solve_exactly(program, {});
    ASSERT_EQ(cheapest.status, LinearStatus::optimal);
    EXPECT_EQ(cheapest.objective, 0.99999999999);
  }
  const auto found = solve_from_doubles(pressed(0.99999999999));
  ASSERT_EQ(found.status, LinearStatus::infeasible);
  const std::vector<double> lower{0, 0, 1e12};
  const std::vector<double> upper{10, 10, 1e12};
  EXPECT_GT(safe_infeasibility(pressed(0.99999999999), found.duals, lower, upper), 0);
  const double below = std::nextafter(1.0, 0.0);
  for (const double most : {0.99999999999, below}) {
    EXPECT_EQ(solve_from_doubles(pressed(most)).status, LinearStatus::infeasible);
    EXPECT_EQ(solve_exactly(pressed(most), {}).status, LinearStatus::infeasible);
  }
  const auto touching = solve_from_doubles(pressed(1));
  ASSERT_EQ(touching.status, LinearStatus::optimal);
  EXPECT_EQ(touching.objective, 1);
  EXPECT_EQ(touching.reduced[2].lower, 0);
  EXPECT_EQ(touching.reduced[2].upper, 0);
}

TEST(ExactSimplex, ProvesThatAnObjectiveHasNoBound) {
  // x - y = 1/10 with free columns: both increase.
  LinearProgram program;
  program.add_column({.cost = -1, .lower = -infinity});
  program.add_column({.lower = -infinity});
  program.add_row({.lower = 0.1, .upper = 0.1}, std::vector<LinearTerm>{{0, 1}, {1, -1}});
  EXPECT_EQ(solve_from_doubles(program).status, LinearStatus::unbounded);
  program.add_row({.upper = 1e15}, std::vector<LinearTerm>{{1, 1e-9}});
  const auto found = solve_from_doubles(program);
  ASSERT_EQ(found.status, LinearStatus::optimal);
  EXPECT_NEAR(found.objective, -1e24, 1e9);
}

TEST(ExactSimplex, SolvesProgramsWithoutRowsOrColumns) {
  LinearProgram program{.constant = 3};
  EXPECT_EQ(solve_exactly(program, {}).objective, 3);
  program.add_column({.cost = -2, .lower = 1, .upper = 4});
  const auto found = solve_exactly(program, {});
  EXPECT_EQ(found.status, LinearStatus::optimal);
  EXPECT_EQ(found.objective, -5);
  EXPECT_THAT(found.values, ElementsAre(4));
  program.columns[0].upper = infinity;
  EXPECT_EQ(solve_exactly(program, {}).status, LinearStatus::unbounded);
  program.columns[0].upper = 0.5;
  EXPECT_EQ(solve_exactly(program, {}).status, LinearStatus::infeasible);
}

TEST(ExactSimplex, EndsWhenItIsStopped) {
  const auto found = solve_exactly(chain(10, 0), {}, [] { return true; });
  EXPECT_EQ(found.status, LinearStatus::interrupted);
}

TEST(RationalFactor, SolvesWithAMatrixAndItsTransposed) {
  // Nearly singular: the second row is the first plus 2^-60 in one entry.
  const mpq_class one_more = 1 + mpq_class(0x1p-60);
  bool too_much = false;
  const auto factor = RationalFactor::of({{{0, 1}, {1, 1}}, {{0, 1}, {1, one_more}}}, {}, too_much);
  ASSERT_TRUE(factor.has_value());
  EXPECT_THAT(factor->solve({2, 2 + mpq_class(0x1p-60)}), ElementsAre(1, 1));
  EXPECT_THAT(factor->solve_transposed({3, 1 + 2 * one_more}), ElementsAre(1, 2));
  EXPECT_FALSE(RationalFactor::of({{{0, 1}, {1, 2}}, {{0, 2}, {1, 4}}}, {}, too_much).has_value());
}

}  // namespace
}  // namespace kusabi::linear
