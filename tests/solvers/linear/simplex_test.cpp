// Simplex tests: results known by hand, both methods against each other on random programs,
// rigorous bounds and infeasibility proofs, and independence of earlier solves.
#include "solvers/linear/simplex.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/wire.hpp"
#include "solvers/linear/glpk_call.hpp"
#include "solvers/linear/safe_bound.hpp"

namespace kusabi::linear {
namespace {

// maximise 3x + 5y, x <= 4, 2y <= 12, 3x + 2y <= 18 (Hillier and Lieberman's first): 36 at (2, 6),
// with shadow prices 0, 3/2 and 1.
LinearProgram window_factory() {
  LinearProgram program;
  const int x = program.add_column({.cost = -3});
  const int y = program.add_column({.cost = -5});
  program.add_row({.upper = 4}, {{{x, 1}}});
  program.add_row({.upper = 12}, {{{y, 2}}});
  program.add_row({.upper = 18}, {{{x, 3}, {y, 2}}});
  return program;
}

LinearProgram random_program(unsigned seed, bool boxed) {
  std::mt19937 draw(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  LinearProgram program;
  const int columns = 4 + static_cast<int>(seed % 9);
  for (int j = 0; j < columns; ++j) {
    program.add_column({.cost = number(draw), .lower = -1, .upper = boxed ? 2 : infinity});
  }
  for (int i = 0; i < 3 + static_cast<int>(seed % 7); ++i) {
    std::vector<LinearTerm> terms;
    for (int j = 0; j < columns; ++j) {
      if (number(draw) > 0) terms.push_back({j, 10 * number(draw)});
    }
    const double middle = 3 * number(draw);
    program.add_row({.lower = i % 3 == 0 ? -infinity : middle, .upper = middle + (i % 2)}, terms);
  }
  return program;
}

TEST(Simplex, FindsTheVertexAndTheShadowPricesOfATextbookProgram) {
  Simplex simplex(window_factory());
  ASSERT_EQ(simplex.solve_primal(), LinearStatus::optimal);
  EXPECT_NEAR(simplex.objective(), -36, 1e-9);
  EXPECT_THAT(simplex.values(), testing::Pointwise(testing::DoubleNear(1e-9), {2.0, 6.0}));
  EXPECT_THAT(simplex.duals(), testing::Pointwise(testing::DoubleNear(1e-9), {0.0, -1.5, -1.0}));
  for (const int column : {0, 1}) EXPECT_NEAR(simplex.reduced_cost(column), 0, 1e-9);
}

TEST(Simplex, ReportsInfeasibleAndUnboundedPrograms) {
  auto program = window_factory();
  program.add_row({.lower = 100}, {{{0, 1}, {1, 1}}});
  EXPECT_EQ(Simplex(program).solve_robustly(), LinearStatus::infeasible);

  LinearProgram open;
  const int x = open.add_column({.cost = -1});
  open.add_row({.lower = 1}, {{{x, 1}}});
  EXPECT_EQ(Simplex(open).solve_robustly(), LinearStatus::unbounded);

  Simplex crossed(window_factory());
  crossed.set_column_bounds(0, 3, 2);
  EXPECT_EQ(crossed.solve_dual(), LinearStatus::infeasible);
  crossed.set_column_bounds(0, 0, infinity);
  EXPECT_EQ(crossed.solve_dual(), LinearStatus::optimal);
}

TEST(Simplex, BothMethodsAgreeAndTheSafeBoundIsCloseBelow) {
  int optimal = 0;
  int infeasible = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    const auto program = random_program(seed, true);
    Simplex primal(program);
    Simplex dual(program);
    const auto status = primal.solve_primal();
    ASSERT_EQ(dual.solve_dual(), status) << seed;
    if (status == LinearStatus::infeasible) {
      ++infeasible;
      std::vector<double> lower(program.columns.size(), -1);
      std::vector<double> upper(program.columns.size(), 2);
      const auto reason = dual.farkas();
      ASSERT_FALSE(reason.empty()) << seed;
      EXPECT_GT(safe_infeasibility(program, reason, lower, upper), 0) << seed;
      continue;
    }
    ASSERT_EQ(status, LinearStatus::optimal) << seed;
    ++optimal;
    EXPECT_NEAR(primal.objective(), dual.objective(), 1e-8) << seed;
    const double bound = safe_dual_bound(program, dual.duals());
    EXPECT_LE(bound, dual.objective() + 1e-9) << seed;
    EXPECT_GE(bound, dual.objective() - 1e-9) << seed;
  }
  EXPECT_GT(optimal, 50);
  EXPECT_GT(infeasible, 50);
}

TEST(Simplex, DoesNotDependOnEarlierSolves) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const auto program = random_program(3 * seed, true);
    Simplex fresh(program);
    Simplex used(program);
    if (used.solve_dual() != LinearStatus::optimal) continue;
    const auto basis = used.basis();
    for (int j = 0; j < used.columns(); ++j) {  // random steps
      used.set_column_bounds(j, 0, 0.5);
      used.solve_dual();
      used.set_column_bounds(j, -1, 2);
    }
    for (auto* simplex : {&fresh, &used}) {
      simplex->set_column_bounds(0, 0.25, 0.75);
      simplex->set_basis(basis);
      simplex->solve_dual();
    }
    ASSERT_EQ(fresh.status(), used.status()) << seed;
    EXPECT_EQ(fresh.values(), used.values()) << seed;
    EXPECT_EQ(fresh.duals(), used.duals()) << seed;
  }
}

TEST(Simplex, ContinuesFromItsBasisAfterRowsAndColumnsAreAdded) {
  Simplex simplex(window_factory());
  ASSERT_EQ(simplex.solve_dual(), LinearStatus::optimal);
  const auto before = simplex.basis();
  // x + y <= 7 moves the optimum to x = 1, y = 6: 33.
  simplex.add_row(-infinity, 7, {{{0, 1}, {1, 1}}});
  simplex.set_basis(before);
  const auto steps = simplex.iterations();
  ASSERT_EQ(simplex.solve_dual(), LinearStatus::optimal);
  EXPECT_NEAR(simplex.objective(), -33, 1e-9);
  EXPECT_EQ(simplex.iterations(), steps + 1);
  // A third product that takes one unit of the third plant: profit 10 each, at most one of them.
  simplex.add_column({.cost = -10, .upper = 1}, {{{2, 0, 1}}});
  ASSERT_EQ(simplex.solve_primal(), LinearStatus::optimal);
  EXPECT_NEAR(simplex.objective(), -43, 1e-9);
  simplex.drop_rows_from(3);
  ASSERT_EQ(simplex.solve_robustly(), LinearStatus::optimal);
  // 17 of the 18 hours are left: 3x + 2y <= 17, so x = 5/3.
  EXPECT_NEAR(simplex.objective(), -45, 1e-9);
}

TEST(Simplex, KeepsItsOptimumWhenInactiveRowsAreDropped) {
  Simplex simplex(window_factory());
  simplex.add_row(-infinity, 100, {{{0, 1}, {1, 1}}});  // row 3: inactive
  simplex.add_row(-infinity, 7, {{{0, 1}, {1, 1}}});    // row 4: active, at x = 1, y = 6
  simplex.add_row(-infinity, 200, {{{1, 1}}});          // row 5: inactive
  ASSERT_EQ(simplex.solve_dual(), LinearStatus::optimal);
  const auto steps = simplex.iterations();
  simplex.drop_rows(std::array{3, 5});
  EXPECT_EQ(simplex.rows(), 4);
  ASSERT_EQ(simplex.solve_dual(), LinearStatus::optimal);
  EXPECT_EQ(simplex.iterations(), steps);
  EXPECT_NEAR(simplex.objective(), -33, 1e-9);
  // Row 4 has become row 3.
  simplex.set_row_bounds(3, -infinity, 6);
  ASSERT_EQ(simplex.solve_dual(), LinearStatus::optimal);
  EXPECT_NEAR(simplex.objective(), -30, 1e-9);  // x = 0, y = 6
  EXPECT_THROW(simplex.drop_rows(std::array{4}), std::out_of_range);
}

TEST(Simplex, StopsAtACutoffOnlyWhenTheOptimumIsAboveIt) {
  for (const double cutoff : {7.0, 9.0}) {
    Simplex simplex(window_factory());
    simplex.set_cost(0, 3);
    simplex.set_cost(1, 5);
    ASSERT_EQ(simplex.solve_dual(), LinearStatus::optimal);
    simplex.set_column_bounds(0, 1, 4);
    simplex.set_column_bounds(1, 1, 4);  // now 8 is the least, at (1, 1)
    EXPECT_EQ(simplex.solve_dual({.cutoff = cutoff}),
              cutoff < 8 ? LinearStatus::cut_off : LinearStatus::optimal);
  }
}

TEST(Simplex, RefusesInvalidPrograms) {
  auto outside = window_factory();
  outside.entries.push_back({7, 0, 1});
  EXPECT_THROW(Simplex{outside}, std::invalid_argument);
  auto twice = window_factory();
  twice.entries.push_back(twice.entries.front());
  EXPECT_THROW(Simplex{twice}, std::invalid_argument);
  auto not_finite = window_factory();
  not_finite.entries.front().value = NAN;
  EXPECT_THROW(Simplex{not_finite}, std::invalid_argument);
  Simplex simplex(window_factory());
  EXPECT_THROW(simplex.set_cost(2, 1), std::out_of_range);
  EXPECT_THROW(simplex.set_row_bounds(-1, 0, 1), std::out_of_range);
  EXPECT_THROW(static_cast<void>(simplex.value(2)), std::out_of_range);
}

TEST(Simplex, AnErrorOfGlpkIsAnExceptionAndTheNextProgramWorks) {
  Simplex lost(window_factory());
  EXPECT_THROW(lost.add_row(0, 1, {{{7, 1}}}), GlpkError);
  EXPECT_THROW(lost.solve_dual(), GlpkError);
  Simplex next(window_factory());
  EXPECT_EQ(next.solve_dual(), LinearStatus::optimal);
}

TEST(Basis, IsUnchangedBySerialisation) {
  Simplex simplex(random_program(6, true));
  simplex.solve_primal();
  const auto basis = simplex.basis();
  Basis copy = engine::unpack<Basis>(engine::pack(basis));
  EXPECT_EQ(copy, basis);
}

TEST(SafeBound, IsMinusInfinityWhereAColumnHasNoBoundAndAResidual) {
  LinearProgram program;
  const int x = program.add_column({.cost = 0.1, .lower = -infinity});
  program.add_row({.lower = 1}, {{{x, 1}}});
  const std::vector<double> exact{0.1};
  const std::vector<double> off{0.1 + 1e-16};
  EXPECT_EQ(safe_dual_bound(program, exact), 0.1);
  EXPECT_EQ(safe_dual_bound(program, off), -infinity);
  program.columns[0].lower = -10;
  program.columns[0].upper = 10;
  EXPECT_LT(safe_dual_bound(program, off), 0.1);
  EXPECT_GT(safe_dual_bound(program, off), 0.1 - 1e-14);
}

TEST(SafeBound, RoundsDownWhereNearestWouldRoundUp) {
  // 1/3 + 1/3 + 1/3 of doubles is less than one; rounding to nearest gives one.
  LinearProgram program;
  const int x = program.add_column({.cost = 0, .lower = 1, .upper = 1});
  for (int i = 0; i < 3; ++i) program.add_row({.lower = 1.0 / 3}, {{{x, 0}}});
  EXPECT_LT(safe_dual_bound(program, std::vector<double>(3, 1.0)), 1.0);
}

// A program that takes many steps: covering rows by dense columns.
LinearProgram long_one() {
  constexpr int size = 800;
  std::mt19937 draw(5);
  std::uniform_real_distribution<double> between(0.1, 1);
  LinearProgram program;
  for (int j = 0; j < size; ++j) program.add_column({.cost = between(draw)});
  for (int i = 0; i < size; ++i) {
    std::vector<LinearTerm> terms;
    for (int j = 0; j < size; ++j) {
      if (between(draw) < 0.5) terms.push_back({j, between(draw)});
    }
    program.add_row({.lower = 10 * between(draw)}, terms);
  }
  return program;
}

TEST(Simplex, StopsBetweenTwoPiecesOfALongSolveOnRequest) {
  Simplex simplex(long_one());
  int times = 0;
  EXPECT_EQ(simplex.solve_primal({.stop = [&] { return ++times == 1; }}),
            LinearStatus::interrupted);
  EXPECT_EQ(times, 1);
  const auto so_far = simplex.iterations();
  EXPECT_GT(so_far, 0U);
  EXPECT_EQ(simplex.solve_primal(), LinearStatus::optimal) << "it goes on from there";
  EXPECT_GT(simplex.iterations(), so_far);
}

TEST(Simplex, IsTheSameWithAStopThatIsNeverRequested) {
  Simplex first(long_one());
  Simplex second(long_one());
  int times = 0;
  EXPECT_EQ(first.solve_primal({.stop = [&] { return ++times < 0; }}), LinearStatus::optimal);
  EXPECT_GT(times, 0);
  EXPECT_EQ(second.solve_primal({.stop = [] { return false; }}), LinearStatus::optimal);
  EXPECT_EQ(first.iterations(), second.iterations());
  EXPECT_EQ(first.values(), second.values());
  EXPECT_EQ(first.duals(), second.duals());
}

}  // namespace
}  // namespace kusabi::linear
