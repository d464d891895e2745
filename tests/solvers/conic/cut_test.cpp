// Tests of cuts in node programs: against results by hand, and against programs in which a further
// candidate replaces the cut.
#include "solvers/conic/cut.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "solvers/conic/node_solver.hpp"
#include "tests/solvers/conic/contact_problem.hpp"
#include "tests/solvers/conic/cut_candidate.hpp"

namespace kusabi::conic {
namespace {

using testing::ContactProblem;
using testing::Masks;

constexpr StopEarly to_the_end{.when_infeasible = false, .when_feasible = false};

// Accuracy goal of the solver, with a margin for the rounding of the two bounds.
constexpr double accuracy_of_cuts = 2e-8;

/// @param cuts max_of() requires them to be present
template <int D>
ConicResult solve_with(NodeSolver<D>& solver, const Masks& node, const std::vector<Cut>& cuts,
                       StopEarly stop = to_the_end) {
  solver.make_room(static_cast<int>(cuts.size()));
  return solver.solve(node.first, node.second, stop, {}, cuts);
}

// One candidate, r_n = 1, F_nn = 1, and a tangential reaction rho against the coupling 1/2:
// u_n = 1 - rho/2, and t = mu - rho without a cut wherever mu <= 1. The cut s - u_n >= level t is
// rho/2 >= level t: where that binds, mu - t = rho = 2 level t.
template <int D>
void expect_the_cut_of_one_candidate(const Eigen::MatrixXd& compliance) {
  for (const double mu : {0.3, 0.75, 0.9})
    for (const double level : {0.25, 1.0, 4.0}) {
      NodeSolver<D> solver(compliance, std::array{mu});
      EXPECT_NEAR(solver.solve(0, 0, to_the_end).lower, mu, accuracy_of_cuts);
      const auto answer = solve_with(
          solver, {0, 0}, {{.candidate = 0, .share = 1, .displacement = 1, .level = level}});
      EXPECT_NEAR(answer.lower, mu / (1 + 2 * level), accuracy_of_cuts);
      EXPECT_NEAR(answer.upper, mu / (1 + 2 * level), accuracy_of_cuts);
      EXPECT_GT(solver.cut_multiplier(0), 0);
      // s/2 - u_n >= t requires rho >= 1 + 2 t of mu - t: no configuration is left.
      const auto infeasible = solve_with(
          solver, {0, 0}, {{.candidate = 0, .share = 0.5, .displacement = 1, .level = 1}}, {});
      EXPECT_EQ(infeasible.sign, Sign::infeasible) << mu;
      const auto value = solve_with(
          solver, {0, 0}, {{.candidate = 0, .share = 0.5, .displacement = 1, .level = 1}});
      EXPECT_NEAR(value.upper, (mu - 1) / 3, accuracy_of_cuts);
      // For the reaction, which is one: s/2 - r_n = -1/2.
      const auto constant =
          solve_with(solver, {0, 0}, {{.candidate = 0, .share = 0.5, .reaction = 1, .level = 2}});
      EXPECT_NEAR(constant.upper, -0.25, accuracy_of_cuts);
      EXPECT_NEAR(constant.lower, -0.25, accuracy_of_cuts);
    }
}

TEST(CutOfOneCandidate, HasItsClosedFormInThePlane) {
  expect_the_cut_of_one_candidate<2>(Eigen::MatrixXd{{1, -0.5}, {-0.5, 2}});
}
TEST(CutOfOneCandidate, HasItsClosedFormInSpace) {
  expect_the_cut_of_one_candidate<3>(Eigen::MatrixXd{{1, 0.3, -0.4}, {0.3, 2, 0}, {-0.4, 0, 1}});
}

std::vector<Cut> random_cuts(const Masks& node, int m, std::mt19937_64& generator) {
  std::uniform_real_distribution<double> number(0.2, 1.5);
  std::vector<Cut> cuts;
  for (int i = 0; i < m; ++i) {
    if (node.first.contains(i) || node.second.contains(i)) continue;
    const double level = number(generator);
    cuts.push_back({.candidate = i,
                    .share = 0.5 * number(generator),
                    .displacement = number(generator),
                    .reaction = number(generator),
                    .level = level});
  }
  return cuts;
}

template <int D>
ContactProblem with_candidates_for(const ContactProblem& problem, const std::vector<Cut>& cuts) {
  ContactProblem larger = problem;
  for (const Cut& cut : cuts) {
    larger.compliance =
        testing::with_candidate_for<D>(cut, larger.compliance, problem.compliance.rows());
    larger.friction.push_back(1);
  }
  return larger;
}

template <int D>
void expect_the_rows_of_further_candidates() {
  std::mt19937_64 generator(17 + D);
  int binding = 0;
  int signs = 0;
  for (int repetition = 0; repetition < 60; ++repetition) {
    const int m = 2 + repetition % 6;
    const auto problem = testing::random_problem(D, m, 0.3, 3, generator);
    Masks node = testing::random_masks(m, generator);
    const auto cuts = random_cuts(node, m, generator);
    if (cuts.empty()) continue;
    NodeSolver<D> solver(problem.compliance, problem.friction);
    const auto without = solver.solve(node.first, node.second, to_the_end);
    const auto answer = solve_with(solver, node, cuts);
    const auto larger = with_candidates_for<D>(problem, cuts);
    NodeSolver<D> judge(larger.compliance, larger.friction);
    Masks all = node;
    for (int i = m; i < larger.candidates(); ++i) all.second.insert(i);
    const auto expected = judge.solve(all.first, all.second, to_the_end);
    EXPECT_LE(answer.upper, without.upper + accuracy_of_cuts);
    if (!expected.has_point || !answer.has_point) continue;
    const double room = accuracy_of_cuts * std::max(1.0, std::abs(expected.upper));
    EXPECT_NEAR(answer.lower, expected.lower, room) << repetition;
    EXPECT_NEAR(answer.upper, expected.upper, room) << repetition;
    binding += answer.upper < without.lower - 1e-3 ? 1 : 0;
    signs += answer.sign != without.sign ? 1 : 0;
  }
  EXPECT_GT(binding, 20);
  EXPECT_GT(signs, 3);
}

TEST(Cuts, AreEquivalentToGapRowsOfFurtherCandidatesInThePlane) {
  expect_the_rows_of_further_candidates<2>();
}
TEST(Cuts, AreEquivalentToGapRowsOfFurtherCandidatesInSpace) {
  expect_the_rows_of_further_candidates<3>();
}

template <int D>
void expect_idle_cuts_to_change_nothing() {
  std::mt19937_64 generator(29 + D);
  constexpr Tolerances sharp{.value = 1e-10};
  constexpr double nothing = 1e-9;
  int feasible = 0;
  for (int repetition = 0; repetition < 40; ++repetition) {
    const int m = 2 + repetition % 6;
    const auto problem = testing::random_problem(D, m, 0.3, 3, generator);
    const Masks node = testing::random_masks(m, generator);
    NodeSolver<D> plain(problem.compliance, problem.friction, sharp);
    const auto expected = plain.solve(node.first, node.second, to_the_end);
    auto cuts = random_cuts(node, m, generator);
    for (Cut& cut : cuts) cut.share = 1e3;
    NodeSolver<D> solver(problem.compliance, problem.friction, sharp);
    const auto answer = solve_with(solver, node, cuts);
    EXPECT_EQ(answer.sign, expected.sign);
    if (expected.sign != Sign::feasible) continue;
    ++feasible;
    EXPECT_NEAR(answer.lower, expected.lower, nothing);
    EXPECT_NEAR(answer.upper, expected.upper, nothing);
  }
  EXPECT_GT(feasible, 8);
}

TEST(Cuts, ThatNeverBindDoNotChangeTheValue) {
  expect_idle_cuts_to_change_nothing<2>();
  expect_idle_cuts_to_change_nothing<3>();
}

TEST(Cuts, DoNotChangeLaterSolvesWithoutThem) {
  std::mt19937_64 generator(43);
  const int m = 6;
  const auto problem = testing::random_problem(3, m, 0.3, 2, generator);
  NodeSolver<3> roomy(problem.compliance, problem.friction);
  roomy.make_room(m + 1);
  NodeSolver<3> plain(problem.compliance, problem.friction);
  for (int repetition = 0; repetition < 20; ++repetition) {
    const Masks other = testing::random_masks(m, generator);
    const auto cuts = random_cuts(other, m, generator);
    roomy.solve(other.first, other.second, to_the_end, {}, cuts);
    const Masks node = testing::random_masks(m, generator);
    for (const StopEarly stop : {StopEarly{}, to_the_end}) {
      const auto first = plain.solve(node.first, node.second, stop);
      const auto again = roomy.solve(node.first, node.second, stop);
      EXPECT_EQ(first.sign, again.sign);
      EXPECT_EQ(first.lower, again.lower);
      EXPECT_EQ(first.upper, again.upper);
      EXPECT_EQ(first.iterations, again.iterations);
      EXPECT_TRUE(plain.reaction() == roomy.reaction());
      EXPECT_TRUE(plain.displacement() == roomy.displacement());
      EXPECT_TRUE(plain.multipliers() == roomy.multipliers());
    }
  }
}

// Candidate 1 is separated, candidate 0 carries all: u_n1 = 0.2 + 0.3 rho with |rho| <= mu as long
// as u_n0 = 1 - rho/2 >= 0, so u_n1 <= 0.2 + 0.3 min(mu, 2).
TEST(MaxOf, IsTheLargestGapOfASeparatedCandidate) {
  Eigen::MatrixXd compliance = Eigen::MatrixXd::Identity(4, 4);
  compliance(0, 1) = compliance(1, 0) = -0.5;
  compliance(0, 2) = compliance(2, 0) = 0.2;
  compliance(1, 2) = compliance(2, 1) = 0.3;
  for (const double mu : {0.4, 1.0, 3.0, 5.0}) {
    const double maximum = 0.2 + 0.3 * std::min(mu, 2.0);
    for (const double known : {1.02 * maximum, 2 * maximum, 0.7 * maximum}) {
      NodeSolver<2> solver(compliance, std::array{mu, 1.0});
      const std::vector<Cut> cuts{
          {.candidate = 1, .share = -known, .displacement = -1, .level = 1e3}};
      solve_with(solver, {0, 0b10}, cuts);
      EXPECT_GE(known + solver.max_of(0), maximum) << mu;
      EXPECT_LE(known + solver.max_of(0), maximum + 1e-4) << mu;
    }
  }
}

// In contact, decoupled from each other: u_n1 = r_n1 - rho_1 / 2 = 0 requires rho_1 = 2 r_n1, which
// friction above 2 allows; then r_n0 has all the rest or nothing, and r_n1 all of the sum. With the
// cut r_n0 >= 3/4 s of the other candidate no more than a quarter is left.
TEST(MaxOf, IsTheLargestReactionOfACandidateInContact) {
  Eigen::MatrixXd compliance = Eigen::MatrixXd::Identity(4, 4);
  compliance(2, 3) = compliance(3, 2) = -0.5;
  NodeSolver<2> solver(compliance, std::array{1.0, 3.0});
  const Cut wanted{.candidate = 1, .share = -2, .reaction = -1, .level = 1e3};
  const std::vector<Cut> alone{wanted};
  solve_with(solver, {0b10, 0}, alone);
  EXPECT_GE(2 + solver.max_of(0), 1);
  EXPECT_LE(2 + solver.max_of(0), 1 + 1e-4);
  const Cut max_of_all{.candidate = 0, .share = -0.75, .reaction = -1, .level = 1};
  const std::vector<Cut> both{max_of_all, wanted};
  solve_with(solver, {0b10, 0}, both);
  EXPECT_GE(2 + solver.max_of(1), 0.25);
  EXPECT_LE(2 + solver.max_of(1), 0.25 + 1e-4);
}

}  // namespace
}  // namespace kusabi::conic
