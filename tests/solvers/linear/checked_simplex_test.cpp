// Checked answers: what passes the check and what does not, and programs that a simplex method in
// doubles gets wrong.
#include "solvers/linear/checked_simplex.hpp"

#include <limits>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

namespace kusabi::linear {
namespace {

// maximise 3x + 5y, x <= 4, 2y <= 12, 3x + 2y <= 18: 36 at (2, 6), with prices 0, 3/2 and 1.
LinearProgram factory() {
  LinearProgram program;
  const int x = program.add_column({.cost = -3});
  const int y = program.add_column({.cost = -5});
  program.add_row({.upper = 4}, {{{x, 1}}});
  program.add_row({.upper = 12}, {{{y, 2}}});
  program.add_row({.upper = 18}, {{{x, 3}, {y, 2}}});
  return program;
}

TEST(CheckedOptimum, IsAVertexWithItsPrices) {
  const auto found = CheckedOptimum::of(factory(), {2, 6}, {0, -1.5, -1});
  ASSERT_TRUE(found);
  EXPECT_DOUBLE_EQ(found->objective(), -36);
  EXPECT_DOUBLE_EQ(found->reduced_cost(0), 0);
}

TEST(CheckedOptimum, IsNotAPointThatViolatesACondition) {
  const auto program = factory();
  const auto passes = [&](std::vector<double> values, std::vector<double> duals) {
    return CheckedOptimum::of(program, std::move(values), std::move(duals)).has_value();
  };
  EXPECT_FALSE(passes({2, 6.1}, {0, -1.5, -1}));  // rows 2 and 3
  EXPECT_FALSE(passes({-1, 6}, {0, -1.5, -1}));   // a bound
  EXPECT_FALSE(passes({0, 6}, {0, -1.5, -1}));    // row 3 has a price and is not active
  EXPECT_FALSE(passes({2, 6}, {0, -1.5, -2}));    // x = 2 has a reduced cost
  EXPECT_FALSE(passes({2, 6}, {0, 1.5, -1}));     // there is no lower bound of row 2
  EXPECT_FALSE(passes({2, 6}, {0, -1.5}));
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(passes({nan, 6}, {0, -1.5, -1}));
  EXPECT_FALSE(passes({2, 6}, {0, nan, -1}));
}

TEST(CheckedInfeasibility, IsACombinationThatExceedsAllBounds) {
  LinearProgram program;  // x + y = 3 with x, y <= 1
  const int x = program.add_column({.upper = 1});
  const int y = program.add_column({.upper = 1});
  program.add_row({.lower = 3, .upper = 3}, {{{x, 1}, {y, 1}}});
  EXPECT_TRUE(CheckedInfeasibility::of(program, {1}));
  EXPECT_TRUE(CheckedInfeasibility::of(program, {1e-30}));
  EXPECT_FALSE(CheckedInfeasibility::of(program, {-1}));
  EXPECT_FALSE(CheckedInfeasibility::of(program, {0}));
  program.rows[0].lower = program.rows[0].upper = 2;  // feasible: (1, 1)
  EXPECT_FALSE(CheckedInfeasibility::of(program, {1}));
}

// Both programs are feasible, at x = 1e8 and at x = 2e12, z = 2 - x.
TEST(CheckedInfeasibility, DropsNoNumberThatAFeasiblePointMakesLarge) {
  LinearProgram free;  // -x <= 0 and 1e-8 x >= 1: the first multiplier belongs to no bound
  const int x = free.add_column({.lower = -infinity});
  free.add_row({.upper = 0}, {{{x, -1}}});
  free.add_row({.lower = 1}, {{{x, 1e-8}}});
  EXPECT_FALSE(CheckedInfeasibility::of(free, {1e-8, 1}));
  LinearProgram bounded;  // x + z >= 1 and (1e-12 - 1) x - z >= 0, with the sum 1e-12 x >= 1
  bounded.add_column({.upper = 1e13});
  const int z = bounded.add_column({.lower = -infinity});
  bounded.add_row({.lower = 1}, {{{x, 1}, {z, 1}}});
  bounded.add_row({.lower = 0}, {{{x, 1e-12 - 1}, {z, -1}}});
  EXPECT_FALSE(CheckedInfeasibility::of(bounded, {1, 1}));
  bounded.columns[0].upper = 1e11;
  EXPECT_TRUE(CheckedInfeasibility::of(bounded, {1, 1}));
}

TEST(CheckedInfeasibility, NeedsNoMultipliersForBoundsThatContradictEachOther) {
  CheckedSimplex simplex(factory());
  simplex.set_column_bounds(0, 2, 1);
  EXPECT_TRUE(std::holds_alternative<CheckedInfeasibility>(simplex.solve()));
}

// Ends of bars of a girder that was turned by cos and sin: y = 1 up to an entry of 1e-16, with
// which GLPK's scale factors make both rows alike.
TEST(CheckedSimplex, IsNotMisledByEntriesThatAreRoundingErrors) {
  LinearProgram program;
  const int x = program.add_column({.cost = -1, .lower = -10, .upper = 10});
  const int y = program.add_column({.lower = -10, .upper = 10});
  program.add_row({.lower = 1, .upper = 1}, {{{x, 1e-16}, {y, 1}}});
  program.add_row({.lower = 3, .upper = 3}, {{{x, 1}, {y, 1e-16}}});
  CheckedSimplex simplex(program);
  ASSERT_TRUE(std::holds_alternative<CheckedOptimum>(simplex.solve()));
  EXPECT_NEAR(simplex.optimum().value(x), 3, 1e-8);
  EXPECT_NEAR(simplex.optimum().value(y), 1, 1e-8);
}

// A program is checked as it is after its changes.
TEST(CheckedSimplex, FollowsTheChangesOfItsProgram) {
  CheckedSimplex simplex(factory());
  ASSERT_TRUE(std::holds_alternative<CheckedOptimum>(simplex.solve()));
  simplex.set_cost(0, -10);
  const int row = simplex.add_row(-infinity, 5, {{{0, 1}, {1, 1}}});
  simplex.set_row_bounds(0, -infinity, 3);
  ASSERT_TRUE(std::holds_alternative<CheckedOptimum>(simplex.solve()));
  EXPECT_NEAR(simplex.optimum().objective(), -10 * 3 - 5 * 2, 1e-9);
  simplex.set_row_bounds(row, 20, infinity);
  EXPECT_TRUE(std::holds_alternative<CheckedInfeasibility>(simplex.solve()));
  simplex.drop_rows_from(row);
  ASSERT_TRUE(std::holds_alternative<CheckedOptimum>(simplex.solve()));
  EXPECT_NEAR(simplex.optimum().objective(), -10 * 3 - 5 * 4.5, 1e-9);
}

TEST(CheckedSimplex, DoesNotDetermineAnUnboundedProgram) {
  LinearProgram program;
  program.add_column({.cost = -1});
  program.add_row({.lower = 0}, {{{0, 1}}});
  CheckedSimplex simplex(program);
  EXPECT_TRUE(std::holds_alternative<NotDetermined>(simplex.solve()));
}

}  // namespace
}  // namespace kusabi::linear
