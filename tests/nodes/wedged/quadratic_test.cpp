// Quadratic forms compared with all leaves of small problems; the proof in doubles and that of the
// verifier both refuse altered multipliers.
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dense.hpp"
#include "nodes/wedged/critical/critical_start.hpp"
#include "nodes/wedged/friction/critical_friction.hpp"
#include "nodes/wedged/quadratic/quadratic_optimiser.hpp"
#include "nodes/wedged/quadratic/quadratic_proof.hpp"
#include "nodes/wedged/tree/candidate_friction.hpp"
#include "random_problem.hpp"
#include "verify/wedged/certificate.hpp"
#include "verify/wedged/proof.hpp"

namespace kusabi::wedged {
namespace {

using support::IndexSet;

problems::WedgedProblem small_problem(int dimension, int candidates, std::uint64_t seed) {
  auto problem = random_problem(dimension, candidates, seed);
  for (int i = 0; i < candidates; ++i) problem.friction.push_back(i % 3 == 1 ? 0.5 : 1);
  return problem;
}

QuadraticBound bound_of(const problems::WedgedProblem& problem) {
  return quadratic_bound(problem, {.enough = 0, .most = 1000});
}

bool sticks(const problems::WedgedProblem& problem, double factor) {
  const auto m = static_cast<int>(problem.contact_names.size());
  CriticalFriction critical(problem, 1e-8);
  for (unsigned contact = 1; contact < 1U << static_cast<unsigned>(m); ++contact)
    if (critical.probe(leaf_with(IndexSet(contact), m), factor).sign != conic::Sign::infeasible)
      return true;
  return false;
}

TEST(QuadraticBound, IsBelowAllLeavesOfSmallProblems) {
  constexpr int m = 5;
  for (const int dimension : {2, 3})
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      const auto problem = small_problem(dimension, m, seed);
      const auto bound = bound_of(problem);
      EXPECT_GT(bound.factor, 0) << dimension << ' ' << seed;
      EXPECT_FALSE(sticks(problem, bound.factor)) << dimension << ' ' << seed;
    }
}

// With one candidate the form is that of its only leaf: mu = F_nn / |F_nt|.
TEST(QuadraticBound, MeetsTheCoefficientOfASingleCandidate) {
  for (const int dimension : {2, 3}) {
    const auto problem = random_problem(dimension, 1, 7);
    const double exact = problem.compliance.matrix(0, 0) /
                         problem.compliance.matrix.row(0).tail(dimension - 1).norm();
    EXPECT_LE(bound_of(problem).factor, exact * (1 + 1e-12));
    EXPECT_NEAR(bound_of(problem).factor, exact, 2e-2 * exact);
  }
}

TEST(QuadraticBound, IsNoneForUnconstrainedBodies) {
  auto problem = random_problem(2, 3, 1);
  problem.modes.matrix = Eigen::MatrixXd::Ones(6, 1);
  EXPECT_EQ(bound_of(problem).factor, 0);
}

verify::Certificate certificate_of(const problems::WedgedProblem& problem, double factor,
                                   const std::vector<double>& numbers) {
  verify::Certificate certificate;
  certificate.dimension = static_cast<std::size_t>(problem.dimension);
  certificate.names = problem.contact_names;
  certificate.friction = candidate_friction(problem, factor);
  certificate.blocks = {certificate.all_candidates()};
  for (const double entry : problem.compliance.stiffness.reshaped())
    certificate.stiffness.push_back(entry);
  verify::Record record;
  record.claim = verify::Claim::form;
  record.numbers = numbers;
  certificate.records.push_back(record);
  return certificate;
}

std::string refusal(const problems::WedgedProblem& problem, double factor,
                    const std::vector<double>& numbers) {
  const auto certificate = certificate_of(problem, factor, numbers);
  const verify::Proof proof(certificate);
  return proof.judgement(certificate.records.front()).refusal.value_or("");
}

TEST(QuadraticForm, IsProvedByTheVerifier) {
  for (const int dimension : {2, 3})
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      auto problem = small_problem(dimension, 7, seed);
      if (seed == 2) problem.friction[4] = 0;
      const auto bound = bound_of(problem);
      EXPECT_EQ(refusal(problem, bound.factor, bound.numbers), "") << dimension << ' ' << seed;
      EXPECT_EQ(refusal(problem, bound.factor / 2, bound.numbers), "");
      EXPECT_THAT(refusal(problem, bound.factor * 1.05, bound.numbers),
                  testing::HasSubstr("not negative definite"));
    }
}

TEST(QuadraticForm, IsRefusedWithAlteredNumbers) {
  constexpr std::size_t m = 7;
  const auto problem = small_problem(3, m, 3);
  const auto bound = bound_of(problem);
  const auto altered = [&](std::size_t at, double value) {
    auto numbers = bound.numbers;
    numbers[at] = value;
    return refusal(problem, bound.factor, numbers);
  };
  EXPECT_THAT(altered(1, -1e-9), testing::HasSubstr("below zero"));
  EXPECT_THAT(altered(1, 100), testing::HasSubstr("not negative definite"));
  EXPECT_THAT(altered(0, 1), testing::HasSubstr("not negative definite"));
  EXPECT_THAT(altered(m * m + 3, 10), testing::HasSubstr("not negative definite"));
  EXPECT_THAT(altered(3 * m * m, 0), testing::HasSubstr("of squares not above"));
  EXPECT_THAT(altered(3 * m * m, 1e3), testing::HasSubstr("not negative definite"));
  EXPECT_THAT(altered(3 * m * m, 1e-9), testing::HasSubstr("not negative definite"));
}

QuadraticMultipliers spectral(const problems::WedgedProblem& problem) {
  const auto m = static_cast<Eigen::Index>(problem.contact_names.size());
  const auto rows = normal_rows(problem);
  return {.products = -Eigen::MatrixXd::Identity(m, m),
          .slips = rows.rightCols(rows.cols() - m),
          .squares = Eigen::VectorXd::Constant(m, 1e-9)};
}

// P = -I and S = F_nt: the form is negative definite below the least eigenvalue of F_nn over
// sym|F_nt|.
TEST(QuadraticProof, HoldsUpToTheSpectralCoefficient) {
  const auto problem = random_problem(3, 9, 5);
  const auto multipliers = spectral(problem);
  const auto m = multipliers.squares.size();
  Eigen::MatrixXd sizes =
      (multipliers.slips.leftCols(m).cwiseAbs2() + multipliers.slips.rightCols(m).cwiseAbs2())
          .cwiseSqrt();
  sizes = (sizes + sizes.transpose()).eval() / 2;
  const Eigen::MatrixXd normal = normal_rows(problem).leftCols(m);
  const double exact = 1 / dense::eigenvalues(sizes, normal).maxCoeff();
  const auto infeasible = [&](double factor) {
    return quadratic_is_infeasible(problem, std::vector<double>(9, factor), multipliers);
  };
  EXPECT_TRUE(infeasible(exact * (1 - 1e-5)));
  EXPECT_FALSE(infeasible(exact * (1 + 1e-5)));
  EXPECT_GT(bound_of(problem).factor, exact);
}

TEST(QuadraticProof, CountsTheErrorOfTheCompliance) {
  auto problem = random_problem(2, 9, 5);
  const auto multipliers = spectral(problem);
  const std::vector<double> friction(9, 0.1);
  EXPECT_TRUE(quadratic_is_infeasible(problem, friction, multipliers));
  problem.compliance.error = 1;
  EXPECT_FALSE(quadratic_is_infeasible(problem, friction, multipliers));
}

}  // namespace
}  // namespace kusabi::wedged
