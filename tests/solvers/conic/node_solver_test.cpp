// NodeSolver tests: closed forms, degenerate nodes, and the early stop of solve().
#include "solvers/conic/node_solver.hpp"

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/solvers/conic/contact_problem.hpp"

namespace kusabi::conic {
namespace {

using testing::ContactProblem;
using testing::Masks;

constexpr StopEarly never{.when_infeasible = false, .when_feasible = false};
constexpr double infinity = std::numeric_limits<double>::infinity();

// Accuracy goal of the solver, with a margin for the rounding of the two bounds.
constexpr double accuracy = 2e-8;

template <int D>
void expect_optimum(NodeSolver<D>& solver, std::uint64_t contact, std::uint64_t separated,
                    double optimum) {
  const ConicResult full = solver.solve(contact, separated, never);
  EXPECT_TRUE(full.has_point);
  EXPECT_NEAR(full.lower, optimum, accuracy);
  EXPECT_NEAR(full.upper, optimum, accuracy);
  const ConicResult early = solver.solve(contact, separated);
  const Sign sign = optimum > 1e-6    ? Sign::feasible
                    : optimum < -1e-6 ? Sign::infeasible
                                      : Sign::unproved;
  EXPECT_EQ(full.sign, sign);
  EXPECT_EQ(early.sign, sign);
}

// One candidate: r_n = 1, and only the size rho of a tangential reaction along the coupling row
// F_nt, of norm a, matters. In contact u_n = F_nn - a rho = 0, so t* = mu - F_nn / a. Undecided,
// t = min(F_nn + a rho, mu - rho): t* = mu if F_nn >= mu, else (a mu + F_nn) / (1 + a).
TEST(NodeSolver, HasTheClosedFormOfOneCandidateInThePlane) {
  Eigen::MatrixXd compliance(2, 2);
  compliance << 1, -0.5, -0.5, 2;
  for (const double mu : {0.25, 0.75, 1.5, 3.0}) {
    NodeSolver<2> solver(compliance, std::array{mu});
    expect_optimum(solver, 1, 0, mu - 2);
    expect_optimum(solver, 0, 0, mu <= 1 ? mu : (0.5 * mu + 1) / 1.5);
  }
}

TEST(NodeSolver, HasTheClosedFormOfOneCandidateInSpace) {
  Eigen::MatrixXd compliance(3, 3);
  compliance << 1, 0.3, -0.4, 0.3, 2, 0, -0.4, 0, 1;  // a = 0.5
  for (const double mu : {0.25, 0.75, 1.5, 3.0}) {
    NodeSolver<3> solver(compliance, std::array{mu});
    expect_optimum(solver, 1, 0, mu - 2);
    expect_optimum(solver, 0, 0, mu <= 1 ? mu : (0.5 * mu + 1) / 1.5);
  }
}

// Decoupled candidates, normal and tangents too: t = min_i c_i r_n with c_i = min(mu_i, F_ii) and
// sum r_n = 1, so t* = 1 / sum 1 / c_i.
TEST(NodeSolver, DividesTheReactionAmongDecoupledCandidates) {
  Eigen::VectorXd diagonal(6);
  diagonal << 0.5, 1, 1.5, 1, 1, 1;
  const std::array friction{0.4, 2.0, 0.5};
  NodeSolver<2> solver(diagonal.asDiagonal(), friction);
  expect_optimum(solver, 0, 0, 1 / (1 / 0.4 + 1 / 1.5 + 1 / 0.5));
  EXPECT_NEAR(solver.reaction().sum(), 1, 1e-12);
}

// One candidate decoupled from its neighbours, wedged with a margin; the separated ones do not
// move, so their u_n = 0 gives t* = 0 exactly: a structurally degenerate node.
TEST(NodeSolver, IsMarginalIfASeparatedCandidateDoesNotMove) {
  Eigen::MatrixXd compliance = Eigen::MatrixXd::Identity(6, 6);
  compliance(0, 1) = compliance(1, 0) = 0.5;
  NodeSolver<2> solver(compliance, std::array{3.0, 1.0, 1.0});
  expect_optimum(solver, 0b001, 0b110, 0);
  expect_optimum(solver, 0b001, 0b010, 0);
}

TEST(NodeSolver, IsMarginalAtTheCriticalFriction) {
  Eigen::MatrixXd compliance(2, 2);
  compliance << 1, 0.5, 0.5, 1;
  NodeSolver<2> solver(compliance, std::array{2.0});  // t* = mu - F_nn / a = 0
  expect_optimum(solver, 1, 0, 0);
  // Just outside of the tolerance the sign is proved.
  NodeSolver<2> above(compliance, std::array{2 + 2e-6}), below(compliance, std::array{2 - 2e-6});
  EXPECT_EQ(above.solve(1, 0).sign, Sign::feasible);
  EXPECT_EQ(below.solve(1, 0).sign, Sign::infeasible);
}

TEST(NodeSolver, IsInfeasibleWithoutIterationsIfAllAreSeparated) {
  NodeSolver<3> solver(Eigen::MatrixXd::Identity(6, 6), std::array{1.0, 1.0});
  const ConicResult answer = solver.solve(0, 0b11);
  EXPECT_EQ(answer.sign, Sign::infeasible);
  EXPECT_EQ(answer.upper, -infinity);
  EXPECT_EQ(answer.iterations, 0);
  EXPECT_FALSE(answer.has_point);
  EXPECT_EQ(solver.reaction().norm(), 0);
}

// All in contact: u_n = F_nn r_n + F_nt r_t = 0 at each of two equal, decoupled nodes, r_n = 1/2.
TEST(NodeSolver, HasNoGapRowIfAllAreInContact) {
  Eigen::MatrixXd compliance = Eigen::MatrixXd::Identity(4, 4);
  compliance(0, 1) = compliance(1, 0) = compliance(2, 3) = compliance(3, 2) = 0.5;
  for (const double mu : {1.0, 3.0}) {
    NodeSolver<2> solver(compliance, std::array{mu, mu});
    expect_optimum(solver, 0b11, 0, (mu - 2) / 2);
  }
}

// No reaction has u_n = F_nn r_n = 0 and sum 1: t* is minus infinity, and y proves it.
TEST(NodeSolver, IsInfeasibleInContactWithoutCoupling) {
  const std::vector<double> friction(5, 0.7);
  Eigen::VectorXd diagonal = Eigen::VectorXd::LinSpaced(15, 0.4, 1.7);
  NodeSolver<3> solver(diagonal.asDiagonal(), friction);
  for (const Masks& masks : {Masks{0b11111, 0}, Masks{0b00100, 0b11011}, Masks{0b10001, 0b01110}})
    for (const StopEarly stop : {StopEarly{}, never}) {
      const ConicResult answer = solver.solve(masks.first, masks.second, stop);
      EXPECT_EQ(answer.sign, Sign::infeasible);
      EXPECT_LT(answer.upper, stop.when_infeasible ? 0 : -1e9);
      EXPECT_FALSE(answer.has_point);
      EXPECT_LT(answer.iterations, 20);
    }
}

TEST(StopEarly, AgreesOnTheSignWithNoMoreIterations) {
  std::mt19937_64 generator(31);
  int fewer = 0;
  for (int repetition = 0; repetition < 60; ++repetition) {
    const int m = 1 + repetition % 8;
    const ContactProblem problem = testing::random_problem(3, m, 0.2, 2, generator);
    NodeSolver<3> solver(problem.compliance, problem.friction);
    const Masks masks = testing::random_masks(m, generator);
    const ConicResult full = solver.solve(masks.first, masks.second, never);
    for (const StopEarly stop : {StopEarly{}, StopEarly{true, false}, StopEarly{false, true}}) {
      const ConicResult early = solver.solve(masks.first, masks.second, stop);
      EXPECT_EQ(early.sign, full.sign);
      EXPECT_LE(early.iterations, full.iterations);
      // The margin for rounding differs from point to point.
      constexpr double rounding = 1e-12;
      EXPECT_LE(early.lower, full.lower + rounding);
      EXPECT_GE(early.upper, full.upper - rounding);
      fewer += early.iterations < full.iterations;
    }
  }
  EXPECT_GT(fewer, 60);
}

TEST(StopEarly, AtInfeasibilityOnlySolvesFeasibleNodesCompletely) {
  Eigen::MatrixXd compliance(2, 2);
  compliance << 1, 0.5, 0.5, 1;
  NodeSolver<2> solver(compliance, std::array{3.0});
  const ConicResult answer = solver.solve(1, 0, {.when_infeasible = true, .when_feasible = false});
  EXPECT_NEAR(answer.lower, 1, accuracy);
  EXPECT_NEAR(answer.upper, 1, accuracy);
}

TEST(NodeSolver, IsMarginalAtTheIterationLimit) {
  Eigen::MatrixXd compliance = Eigen::MatrixXd::Identity(4, 4);
  compliance(0, 1) = compliance(1, 0) = 0.5;
  NodeSolver<2> solver(compliance, std::array{3.0, 0.1}, Tolerances{.iterations = 1});
  const ConicResult answer = solver.solve(0b01, 0b10, never);  // t* = 0
  EXPECT_EQ(answer.iterations, 1);
  EXPECT_EQ(answer.sign, Sign::unproved);
  EXPECT_LE(answer.lower, 0);
  EXPECT_GT(answer.upper, 1e-3);
}

TEST(NodeSolver, DoesNotDependOnEarlierSolves) {
  std::mt19937_64 generator(41);
  const int m = 7;
  const ContactProblem problem = testing::random_problem(3, m, 0.3, 1.5, generator);
  std::vector<Masks> nodes;
  nodes.reserve(20);
  for (int i = 0; i < 20; ++i) nodes.push_back(testing::random_masks(m, generator));
  NodeSolver<3> used(problem.compliance, problem.friction);
  for (const Masks& other : nodes)
    for (const Masks& masks : nodes) {
      used.solve(other.first, other.second, never);
      const ConicResult again = used.solve(masks.first, masks.second);
      NodeSolver<3> fresh(problem.compliance, problem.friction);
      const ConicResult first = fresh.solve(masks.first, masks.second);
      EXPECT_EQ(first.sign, again.sign);
      EXPECT_EQ(first.lower, again.lower);
      EXPECT_EQ(first.upper, again.upper);
      EXPECT_EQ(first.iterations, again.iterations);
      EXPECT_TRUE(fresh.reaction() == used.reaction());
      EXPECT_TRUE(fresh.displacement() == used.displacement());
      EXPECT_TRUE(fresh.multipliers() == used.multipliers());
    }
}

}  // namespace
}  // namespace kusabi::conic
