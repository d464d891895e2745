// Certificate tests: both bounds of the solver are checked in the original variables of the node
// program, and against an ellipsoid method that shares nothing with the solver.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "solvers/conic/node_solver.hpp"
#include "tests/solvers/conic/contact_problem.hpp"

namespace kusabi::conic {
namespace {

using testing::ContactProblem;
using testing::contains;
using testing::Masks;

constexpr StopEarly never{.when_infeasible = false, .when_feasible = false};

// Equations of a reaction: rounding of F r for data of order one, with a margin.
constexpr double feasibility = 1e-11;
// Sums of m products with multipliers of their own magnitude.
constexpr double rounding = 1e-12;
// Required width of a bracket: ten times the solver's goal.
constexpr double bracket_width = 1e-7;

// Expects that (r, lower) satisfies all constraints of the node program.
void expect_proved_from_below(const ContactProblem& problem, const Masks& masks,
                              const Eigen::VectorXd& r, double lower) {
  const Eigen::VectorXd u = problem.compliance * r;
  double sum = 0;
  for (int i = 0; i < problem.candidates(); ++i) {
    const int at = problem.d * i;
    sum += r[at];
    if (contains(masks.first, i)) {
      // The lower bound includes the cost of the residual; if the bound is negative this cost may
      // be large and does not matter.
      if (lower > 0) {
        EXPECT_NEAR(u[at], 0, feasibility);
      }
    }
    if (contains(masks.second, i)) {
      EXPECT_EQ(r.segment(at, problem.d).norm(), 0);
    }
  }
  EXPECT_NEAR(sum, 1, feasibility);
  EXPECT_GE(testing::level(problem, masks, r), lower - rounding);
}

// Proves that no (r, t) with t > upper satisfies the node program. With w = sum_i y_i (row (n, i)
// of F):
//   w'r >= t Y,  Y = sum of y over the rows not in U, all of these y >= 0;
//   w'r <= tau (1 - omega t) + t sum_C w_n / mu  for any tau >= w_n + mu ||w_t|| on C, since
//   r_n = x + t / mu and ||r_t|| <= mu x with x >= 0 and sum x = 1 - omega t. Together t (Y + omega
//   tau - sum_C w_n / mu) <= tau.
void expect_proved_from_above(const ContactProblem& problem, const Masks& masks,
                              const Eigen::VectorXd& y, double upper) {
  const int d = problem.d, m = problem.candidates();
  Eigen::VectorXd w = Eigen::VectorXd::Zero(d * m);
  double total = 0, omega = 0, scale = 1, tau = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < m; ++i) {
    w += y[i] * problem.compliance.row(d * i).transpose();
    scale += std::abs(y[i]);
    if (!contains(masks.first, i)) {
      EXPECT_GE(y[i], 0);
      total += y[i];
    }
    if (!contains(masks.second, i)) omega += 1 / problem.friction[static_cast<std::size_t>(i)];
  }
  double weighted = 0;
  for (int i = 0; i < m; ++i) {
    if (contains(masks.second, i)) continue;
    const double mu = problem.friction[static_cast<std::size_t>(i)];
    weighted += w[d * i] / mu;
    tau = std::max(tau, w[d * i] + mu * w.segment(d * i + 1, d - 1).norm());
  }
  // Without multipliers, y = 0, the cones alone give t <= 1 / omega.
  if (upper * omega >= 1 - rounding) return;
  EXPECT_LE(tau, upper * (total + omega * tau - weighted) + rounding * scale * m * m);
}

// Checks both proofs, and that the sign follows from the bounds.
template <int D>
ConicResult proved(const ContactProblem& problem, NodeSolver<D>& solver, const Masks& masks,
                   StopEarly stop) {
  const int m = problem.candidates();
  const ConicResult answer = solver.solve(masks.first, masks.second, stop);
  SCOPED_TRACE(::testing::Message() << "m = " << m << ", U = " << hexadecimal(masks.first)
                                    << ", R = " << hexadecimal(masks.second) << ", t* in ["
                                    << answer.lower << ", " << answer.upper << "]");
  if (answer.has_point) expect_proved_from_below(problem, masks, solver.reaction(), answer.lower);
  expect_proved_from_above(problem, masks, solver.multipliers(), answer.upper);
  EXPECT_LE(answer.lower, answer.upper + rounding);
  EXPECT_LE((solver.displacement() - problem.compliance * solver.reaction()).norm(), rounding * m);
  EXPECT_EQ(answer.sign == Sign::feasible, answer.has_point && answer.lower > 1e-12);
  EXPECT_EQ(answer.sign == Sign::infeasible, answer.upper < -1e-12);
  if (!stop.when_infeasible) {
    EXPECT_TRUE(answer.has_point);
    EXPECT_LE(answer.gap, bracket_width * std::max(1.0, std::abs(answer.upper)));
  }
  return answer;
}

template <int D>
void expect_certificates(double minimum, double maximum, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  int feasible = 0, infeasible = 0;
  for (int repetition = 0; repetition < 25; ++repetition)
    for (int m = 1; m <= 8; ++m) {
      const ContactProblem problem = testing::random_problem(D, m, minimum, maximum, generator);
      NodeSolver<D> solver(problem.compliance, problem.friction);
      const Masks masks = testing::random_masks(m, generator);
      for (const StopEarly stop : {StopEarly{}, never}) {
        const ConicResult answer = proved(problem, solver, masks, stop);
        if (!stop.when_infeasible) {
          feasible += answer.sign == Sign::feasible;
          infeasible += answer.sign == Sign::infeasible;
        }
      }
    }
  // Both signs must occur, so that the test covers both.
  EXPECT_GT(feasible, 20);
  EXPECT_GT(infeasible, 20);
}

TEST(Certificates, AreValidInThePlane) {
  expect_certificates<2>(0.3, 1.5, 11);
}
TEST(Certificates, AreValidInSpace) {
  expect_certificates<3>(0.3, 1.5, 12);
}
// Sets of candidates that take two words: some in U, some in R on either side of the border.
TEST(Certificates, AreValidForAHundredCandidates) {
  constexpr int m = 100;
  std::mt19937_64 generator(15);
  const ContactProblem problem = testing::random_problem(2, m, 5, 10, generator);
  NodeSolver<2> solver(problem.compliance, problem.friction);
  EXPECT_EQ(proved(problem, solver, {}, never).sign, Sign::feasible);
  for (int repetition = 0; repetition < 6; ++repetition) {
    const Masks masks = testing::random_masks(m, generator);
    for (const StopEarly stop : {StopEarly{}, never}) proved(problem, solver, masks, stop);
  }
  // Without friction nothing wedges.
  NodeSolver<2> slippery(problem.compliance, std::vector<double>(m, 1e-3));
  const ContactProblem same{2, problem.compliance, std::vector<double>(m, 1e-3)};
  EXPECT_EQ(proved(same, slippery, {support::IndexSet::below(70), {}}, never).sign,
            Sign::infeasible);
}
TEST(Certificates, AreValidForBadlyScaledFrictionInThePlane) {
  expect_certificates<2>(0.01, 10, 13);
}
TEST(Certificates, AreValidForBadlyScaledFrictionInSpace) {
  expect_certificates<3>(0.01, 10, 14);
}

// Maximum of level(r) over the affine set of the equations, by the ellipsoid method: level is
// concave, so each supergradient cuts off half of the ellipsoid without the maximum.
double search(const ContactProblem& problem, const Masks& masks) {
  constexpr double radius = 100, enough = 1e-8;
  const Eigen::MatrixXd matrix = testing::equations(problem, masks);
  const Eigen::VectorXd right_side = Eigen::VectorXd::Unit(matrix.rows(), matrix.rows() - 1);
  const Eigen::MatrixXd directions = dense::kernel(matrix, 1e-12);
  const auto n = static_cast<double>(directions.cols());

  Eigen::VectorXd r = dense::least_squares(matrix, right_side, 1e-12);
  Eigen::VectorXd slope;
  double maximum = testing::level(problem, masks, r, &slope);
  // The ellipsoid is the image of the unit ball under `axes`; this form stays an ellipsoid under
  // rounding.
  Eigen::MatrixXd axes = radius * Eigen::MatrixXd::Identity(directions.cols(), directions.cols());
  for (int iteration = 0; iteration < 10000; ++iteration) {
    const Eigen::VectorXd pull = axes.transpose() * (directions.transpose() * slope);
    if (pull.norm() < enough) break;  // no point of the ellipsoid is greater by more
    const Eigen::VectorXd up = pull.normalized();
    const Eigen::VectorXd push = axes * up;
    r += directions * push / (n + 1);
    if (n == 1) {
      axes /= 2;
    } else {
      axes += (std::sqrt((n - 1) / (n + 1)) - 1) * push * up.transpose();
      axes *= n / std::sqrt(n * n - 1);
    }
    maximum = std::max(maximum, testing::level(problem, masks, r, &slope));
  }
  return maximum;
}

template <int D>
void expect_agreement_with_search(int max_candidates, std::uint64_t seed) {
  constexpr double reach = 1e-6;  // accuracy of the ellipsoid method, with its rounding
  std::mt19937_64 generator(seed);
  for (int repetition = 0; repetition < 100; ++repetition) {
    const int m = 1 + repetition % max_candidates;
    const ContactProblem problem = testing::random_problem(D, m, 0.3, 1.5, generator);
    const Masks masks = testing::random_masks(m, generator);
    NodeSolver<D> solver(problem.compliance, problem.friction);
    const ConicResult answer = solver.solve(masks.first, masks.second, never);
    const double found = search(problem, masks);
    SCOPED_TRACE(::testing::Message() << "m = " << m << ", U = " << hexadecimal(masks.first)
                                      << ", R = " << hexadecimal(masks.second));
    EXPECT_LE(found, answer.upper + rounding);
    EXPECT_GE(found, answer.lower - reach * std::max(1.0, std::abs(answer.lower)));
  }
}

TEST(Certificates, AgreeWithTheEllipsoidMethodInThePlane) {
  expect_agreement_with_search<2>(5, 21);
}
TEST(Certificates, AgreeWithTheEllipsoidMethodInSpace) {
  expect_agreement_with_search<3>(5, 22);
}

}  // namespace
}  // namespace kusabi::conic
