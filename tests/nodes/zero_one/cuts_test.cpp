// Steps at the root: cuts, smaller M, implied bounds and ranges must keep all relevant points, and
// each step must improve the relaxation.
#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nodes/zero_one/big_m.hpp"
#include "nodes/zero_one/bound_tightening.hpp"
#include "nodes/zero_one/cut_rounds.hpp"
#include "nodes/zero_one/disjunctive_cuts.hpp"
#include "tests/nodes/zero_one/programs.hpp"

namespace kusabi::zero_one {
namespace {

using linear::LinearStatus;
using linear::LinearTerm;
using tests::by_brute_force;
using tests::random_mixed;

// Minimum of a form over all points: the program with the form as costs.
std::optional<double> min_of(linear::MixedProgram mixed, const std::vector<LinearTerm>& form) {
  mixed.program.constant = 0;
  for (auto& column : mixed.program.columns) column.cost = 0;
  for (const auto& [column, value] : form) {
    mixed.program.columns[static_cast<std::size_t>(column)].cost = value;
  }
  return by_brute_force(mixed);
}

TEST(DisjunctiveCuts, AreSatisfiedByAllPointsAndCutOffTheOptimumOfTheRelaxation) {
  int cuts = 0;
  for (int kind = 0; kind < 4; ++kind) {
    for (unsigned seed = 0; seed < 6; ++seed) {
      const auto mixed = random_mixed(seed, kind, 7);
      Relaxation relaxation(mixed);
      if (relaxation.solve(relaxation.root(), {}) != LinearStatus::optimal) continue;
      const auto point = relaxation.values();
      for (std::size_t k = 0; k < relaxation.binaries(); ++k) {
        const double at = point[static_cast<std::size_t>(relaxation.column(k))];
        if (std::min(at, 1 - at) < 1e-6) continue;
        const auto cut = deepest_cut(relaxation, mixed.program.rows.size(), point, k);
        if (!cut) continue;
        ++cuts;
        double at_point = 0;
        for (const auto& [column, value] : cut->terms) {
          at_point += value * point[static_cast<std::size_t>(column)];
        }
        EXPECT_LT(at_point, cut->lower);
        const auto minimum = min_of(mixed, cut->terms);
        if (minimum) {
          EXPECT_GE(*minimum, cut->lower - 1e-8) << kind << " " << seed << " " << k;
        }
      }
    }
  }
  EXPECT_GT(cuts, 15);
}

TEST(DisjunctiveCuts, ReachTheHullOfBothSides) {
  // x <= tau, x <= 1 - tau with 0 <= x <= 1: both sides of the disjunction imply x = 0, the
  // relaxation allows x = 1/2 at tau = 1/2.
  linear::MixedProgram mixed;
  const int tau = mixed.program.add_column({.upper = 1});
  const int x = mixed.program.add_column({.cost = -1, .upper = 1});
  mixed.binaries = {tau};
  mixed.program.add_row({.upper = 0}, {{{x, 1}, {tau, -1}}});
  mixed.program.add_row({.upper = 1}, {{{x, 1}, {tau, 1}}});
  Relaxation relaxation(mixed);
  ASSERT_EQ(relaxation.solve(relaxation.root(), {}), LinearStatus::optimal);
  ASSERT_NEAR(relaxation.objective(), -0.5, 1e-9);
  const auto rounds = add_disjunctive_cuts(relaxation, relaxation.basis());
  EXPECT_EQ(rounds.kept, 1U);
  EXPECT_NEAR(relaxation.objective(), 0, 1e-9);
}

// Step 4 of Algorithm 5.1: after a cut that was not kept, J is without its binary, and no other.
TEST(CutOrder, OmitsTheLastRejectedBinaryOnly) {
  const std::vector<double> residual{0.1, 0.25, 0.2, 0};
  CutOrder order(4);
  EXPECT_EQ(order.next(residual), 1U);
  order.rejected(1);
  EXPECT_EQ(order.next(residual), 2U);
  order.rejected(2);
  EXPECT_EQ(order.next(residual), 1U);
  order.kept();
  EXPECT_EQ(order.next(residual), 1U);
}

TEST(CutOrder, TriesNoBinaryTwiceAtOnePoint) {
  const std::vector<double> residual{0.1, 0.25, 0.2, 0};
  CutOrder order(4);
  order.rejected(2);
  EXPECT_EQ(order.next(residual), 1U);
  order.found_none(1);
  EXPECT_EQ(order.next(residual), 2U);
  order.found_none(2);
  EXPECT_EQ(order.next(residual), 0U);
  order.found_none(0);
  EXPECT_EQ(order.next(residual), std::nullopt);
  order.rejected(0);  // there is another point
  EXPECT_EQ(order.next(residual), 1U);
}

// A single binary is tried again at the next point.
TEST(CutOrder, TriesRejectedBinariesIfNoOthersAreLeft) {
  CutOrder order(1);
  order.rejected(0);
  EXPECT_EQ(order.next({0.2}), 0U);
  EXPECT_EQ(order.next({0}), std::nullopt);
}

TEST(DisjunctiveCuts, RaiseTheBoundWithinTheLimitOfRounds) {
  int raised = 0;
  for (unsigned seed = 0; seed < 6; ++seed) {
    const auto mixed = random_mixed(seed, 0, 10);
    Relaxation relaxation(mixed);
    ASSERT_EQ(relaxation.solve(relaxation.root(), {}), LinearStatus::optimal);
    const double before = relaxation.bound();
    const auto rounds = add_disjunctive_cuts(relaxation, relaxation.basis());
    ASSERT_EQ(relaxation.solve(relaxation.root(), rounds.basis), LinearStatus::optimal);
    EXPECT_LE(rounds.rounds, 18U);  // 1.8 x 10
    EXPECT_GE(rounds.found, rounds.kept);
    EXPECT_EQ(relaxation.program().rows.size(), mixed.program.rows.size() + rounds.kept);
    EXPECT_GE(relaxation.bound(), before - 1e-9);
    raised += relaxation.bound() > before + 1e-6 ? 1 : 0;
    EXPECT_LE(relaxation.bound(), *by_brute_force(mixed));
  }
  EXPECT_GE(raised, 4);
}

TEST(BoundTightening, RangesContainAllPointsWithinTheCutoff) {
  int bounded = 0;
  for (int kind = 2; kind < 5; ++kind) {
    for (unsigned seed = 0; seed < 8; ++seed) {
      auto mixed = random_mixed(seed, kind, 6);
      const auto optimum = by_brute_force(mixed);
      if (!optimum) continue;
      BoundTightening ends(mixed.program, *optimum + 1);
      const std::vector<LinearTerm> form{{6, 1}, {7, -2}, {0, 3}};
      const auto range = ends.range(form);
      // The same cutoff as a row, for all binaries.
      std::vector<LinearTerm> objective;
      for (std::size_t j = 0; j < mixed.program.columns.size(); ++j) {
        objective.push_back({static_cast<int>(j), mixed.program.columns[j].cost});
      }
      mixed.program.add_row({.upper = *optimum + 1}, objective);
      const auto minimum = min_of(mixed, form);
      const auto maximum = min_of(mixed, {{6, -1}, {7, 2}, {0, -3}});
      if (minimum) {
        EXPECT_LE(range.lower, *minimum + 1e-12);
      }
      if (maximum) {
        EXPECT_GE(range.upper, -*maximum - 1e-12);
      }
      if (std::isfinite(range.lower) && std::isfinite(range.upper)) ++bounded;
    }
  }
  EXPECT_GT(bounded, 10);
}

TEST(BoundTightening, ReportsAnEmptyRange) {
  const auto mixed = random_mixed(1, 2, 6);
  BoundTightening ends(mixed.program, -1);  // costs and flows are never negative there
  const auto range = ends.range(std::vector<LinearTerm>{{6, 1}});
  EXPECT_GT(range.lower, range.upper);
}

TEST(BigMs, AreReducedToTheLeastValidValues) {
  // gamma <= |u| with -3 <= u <= 4 and M = 100, as in (29): gamma - u <= M (1 - tau) needs
  // M = 6 where u = -3 (gamma = 3), gamma + u <= M tau needs 8.
  linear::MixedProgram mixed;
  auto& program = mixed.program;
  const int tau = program.add_column({.upper = 1});
  const int u = program.add_column({.lower = -3, .upper = 4});
  const int gamma = program.add_column({.cost = -1});
  mixed.binaries = {tau};
  program.add_row({.upper = 100}, {{{gamma, 1}, {u, -1}, {tau, 100}}});
  program.add_row({.lower = 0}, {{{gamma, -1}, {u, -1}, {tau, 100}}});
  BigMs big_ms(mixed);
  big_ms.tighten(mixed, 0);
  EXPECT_EQ(big_ms.smaller(), 2U);
  EXPECT_NEAR(program.rows[0].upper, 6, 1e-9);
  EXPECT_NEAR(program.entries[2].value, 6, 1e-9);
  EXPECT_NEAR(program.entries[5].value, 8, 1e-9);
  EXPECT_NEAR(*by_brute_force(mixed), -4, 1e-9);
}

// t - 1000 y <= 0 with t <= 0 does not depend on y.
linear::MixedProgram with_a_needless_m(double maximum) {
  linear::MixedProgram mixed;
  auto& program = mixed.program;
  const int y = program.add_column({.cost = -3, .upper = 1});
  const int t = program.add_column({.lower = -5, .upper = maximum});
  mixed.binaries = {y};
  program.add_row({.upper = 0}, {{{y, -1000}, {t, 1}}});
  return mixed;
}

TEST(BigMs, AreZeroIfTheRowIsSatisfiedWithoutThem) {
  auto mixed = with_a_needless_m(0);
  BigMs big_ms(mixed);
  const auto done = big_ms.tighten(mixed, 0);
  EXPECT_EQ(mixed.program.entries[0].value, 0);
  EXPECT_EQ(big_ms.smaller(), 1U);
  EXPECT_LE(done.rounds, 2U);
  // A second call has nothing to change and counts nothing twice.
  EXPECT_FALSE(big_ms.tighten(mixed, 0).changed);
  EXPECT_EQ(big_ms.smaller(), 1U);
}

TEST(BigMs, KeepAShareOfTheRowAfterRepeatedTightening) {
  // The row needs 1e-12, which is negligible beside t.
  auto mixed = with_a_needless_m(1e-12);
  BigMs big_ms(mixed);
  for (int time = 0; time < 5; ++time) big_ms.tighten(mixed, 0);
  EXPECT_LE(mixed.program.entries[0].value, -1e-12);
  EXPECT_LE(-mixed.program.entries[0].value, 1e-5);
  EXPECT_GE(-mixed.program.entries[0].value, 1e-9);
  EXPECT_EQ(big_ms.smaller(), 1U);
}

TEST(BigMs, DoNotExcludeTheOptimum) {
  std::uint64_t shrunk = 0;
  for (int kind = 2; kind < 5; ++kind) {
    for (unsigned seed = 0; seed < 10; ++seed) {
      auto mixed = random_mixed(seed, kind, 6);
      const auto before = by_brute_force(mixed);
      if (!before) continue;
      BigMs big_ms(mixed);
      big_ms.tighten(mixed, *before + 0.5);
      shrunk += big_ms.smaller();
      const auto after = by_brute_force(mixed);
      ASSERT_TRUE(after.has_value()) << kind << " " << seed;
      EXPECT_NEAR(*after, *before, 1e-8) << kind << " " << seed;
    }
  }
  EXPECT_GT(shrunk, 4U);
}

TEST(ImpliedBounds, FollowFromRowsAndAreRoundedOutwards) {
  linear::LinearProgram program;
  const int x = program.add_column({.lower = -linear::infinity});
  const int y = program.add_column({.cost = 3});
  const int tau = program.add_column({.upper = 1});
  program.add_row({.upper = 0}, {{{x, 1}, {tau, -7}}});              // x <= 7 tau
  program.add_row({.lower = -2, .upper = 5}, {{{x, 3}, {tau, 1}}});  // 3x >= -2 - tau
  const auto bounds = implied_bounds(program, 12);                   // 3y <= 12
  EXPECT_NEAR(bounds.lower[static_cast<std::size_t>(x)], -1, 1e-12);
  EXPECT_LE(bounds.lower[static_cast<std::size_t>(x)], -1);
  EXPECT_NEAR(bounds.upper[static_cast<std::size_t>(x)], 5.0 / 3, 1e-12);
  EXPECT_NEAR(bounds.upper[static_cast<std::size_t>(y)], 4, 1e-12);
}

}  // namespace
}  // namespace kusabi::zero_one
