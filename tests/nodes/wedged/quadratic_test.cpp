// Quadratic forms compared with all leaves of small problems; the proof in doubles and that of the
// verifier both refuse altered multipliers.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dense.hpp"
#include "faces.hpp"
#include "nodes/wedged/critical/critical_start.hpp"
#include "nodes/wedged/friction/critical_friction.hpp"
#include "nodes/wedged/quadratic/quadratic_optimiser.hpp"
#include "nodes/wedged/quadratic/quadratic_proof.hpp"
#include "nodes/wedged/tree/candidate_friction.hpp"
#include "nodes/wedged/tree/evidence_check.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/structure/checks/checked_structure.hpp"
#include "problems/wedged/wedged_problem.hpp"
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
  return quadratic_bound(problem, {.enough = 0, .maximum = 1000});
}

bool sticks(const problems::WedgedProblem& problem, double factor) {
  const auto m = static_cast<int>(problem.contact_names.size());
  CriticalFriction critical(problem, 1e-8);
  for (unsigned contact = 1; contact < 1U << static_cast<unsigned>(m); ++contact)
    if (critical.probe(leaf_with(IndexSet(contact), m), factor).sign != conic::Sign::infeasible)
      return true;
  return false;
}

TEST(QuadraticBound, IsInfeasibleForAllLeavesOfSmallProblems) {
  constexpr int m = 5;
  for (const int dimension : {2, 3})
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      const auto problem = small_problem(dimension, m, seed);
      const auto bound = bound_of(problem);
      EXPECT_GT(bound.factor, 0) << dimension << ' ' << seed;
      EXPECT_FALSE(sticks(problem, bound.factor)) << dimension << ' ' << seed;
    }
}

TEST(QuadraticBound, IsThatOfTheFirstMultipliersWithoutRounds) {
  const auto problem = small_problem(3, 7, 3);
  const auto first = quadratic_bound(problem, {.enough = 0, .maximum = 1000, .rounds = 0});
  EXPECT_GT(first.factor, 0);
  EXPECT_EQ(first.evaluations, 0);
  EXPECT_LT(first.factor, bound_of(problem).factor);
}

// A larger coefficient is not asked for, and this one is met exactly.
TEST(QuadraticBound, IsAtMostTheRequestedMaximum) {
  const auto problem = small_problem(3, 7, 3);
  const double maximum = bound_of(problem).factor / 2;
  EXPECT_EQ(quadratic_bound(problem, {.enough = 0, .maximum = maximum}).factor, maximum);
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

// A block with two sides in contact, across which the mesh has one element.
problems::Structure loose_block(const std::string& corners, int along, const std::string& left,
                                const std::string& right) {
  return problems::read_structure(
      fmt::format("name = \"block\"\ndimension = 2\nunits = {{ length = \"mm\", force = \"N\" }}\n"
                  "[[mesh]]\nname = \"b\"\ncorners = {}\ndivisions = [1, {}]\nE = 1e3\nnu = 0.3\n"
                  "thickness = 1\nplane = \"strain\"\n"
                  "[[contact]]\nnodes = [\"b.left\"]\nnormal = {}\n"
                  "[[contact]]\nnodes = [\"b.right\"]\nnormal = {}\n",
                  corners, along, left, right),
      "block.toml");
}

// Sides parallel to a direction (a, 1), along which the block may slide; b = a, except for digits
// of the right wall.
problems::Structure between_parallel_walls(double a, double b) {
  return loose_block(fmt::format("[[0, 0], [1, 0.2], [{}, 1.5], [{}, 1]]", 1 + 1.3 * a, a), 2,
                     fmt::format("[1, {}]", -a), fmt::format("[-1, {}]", b));
}

TEST(QuadraticBound, IsInfeasibleForAllLeavesBetweenParallelWalls) {
  for (const double a : {0.0, 0.5}) {
    const auto problem = problems::wedged_problem(problems::checked(between_parallel_walls(a, a)));
    ASSERT_EQ(problem.modes.matrix.cols(), 3);
    const auto bound = bound_of(problem);
    EXPECT_GT(bound.factor, 0.1) << a;
    EXPECT_FALSE(sticks(problem, bound.factor)) << a;
  }
}

TEST(QuadraticBound, IsZeroForBodiesThatARigidBodyModeLiftsOff) {
  const auto wedge =
      loose_block("[[-0.5, 0], [0.5, 0], [0.8, 1], [-0.8, 1]]", 2, "[1, 0.3]", "[-1, 0.3]");
  EXPECT_EQ(bound_of(problems::wedged_problem(problems::checked(wedge))).factor, 0);
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
  certificate.theorems.resize(1);
  certificate.nodes.push_back({.claim = verify::Claim::form, .numbers = numbers});
  return certificate;
}

std::string refusal(const problems::WedgedProblem& problem, double factor,
                    const std::vector<double>& numbers) {
  const auto certificate = certificate_of(problem, factor, numbers);
  const verify::Proof proof(certificate);
  return proof.proof_result(certificate.nodes.front()).refusal.value_or("");
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

// Verdicts of the verifier on forms of a structure.
struct LooseProof {
  explicit LooseProof(const problems::Structure& structure)
      : problem(problems::wedged_problem(problems::checked(structure))),
        enclosed(std::get<verify::EnclosedProblem>(enclosed_stiffness(structure))),
        bound(bound_of(problem)) {}

  [[nodiscard]] bool holds(double factor, const std::vector<double>& numbers,
                           LargeDisplacements far = LargeDisplacements::counted) const {
    const EvidenceCheck check(problem, enclosed, candidate_friction(problem, factor), {}, far);
    return check.holds({.kind = Evidence::Kind::form, .block = 0, .node = {}, .numbers = numbers});
  }
  [[nodiscard]] bool holds_altered(std::size_t at, double value) const {
    auto numbers = bound.numbers;
    numbers[at] = value;
    return holds(bound.factor, numbers, LargeDisplacements::left_out);
  }

  problems::WedgedProblem problem;
  verify::EnclosedProblem enclosed;
  QuadraticBound bound;
};

TEST(QuadraticForm, IsProvedForUnconstrainedBodies) {
  const LooseProof proof(between_parallel_walls(0, 0));
  EXPECT_GT(proof.bound.factor, 0);
  EXPECT_TRUE(proof.holds(proof.bound.factor, proof.bound.numbers));
  EXPECT_FALSE(proof.holds(proof.bound.factor * 1.05, proof.bound.numbers));
}

// The sides slide along walls that are parallel up to the sixteenth digit.
TEST(QuadraticForm, IsProvedExceptForLargeDisplacementsAlongInclinedWalls) {
  const LooseProof proof(between_parallel_walls(0.3, std::nextafter(0.3, 1)));
  EXPECT_TRUE(proof.holds(proof.bound.factor, proof.bound.numbers, LargeDisplacements::left_out));
  EXPECT_FALSE(proof.holds(proof.bound.factor, proof.bound.numbers, LargeDisplacements::counted));
}

TEST(QuadraticForm, IsRefusedForUnconstrainedBodiesWithAlteredNumbers) {
  const LooseProof proof(between_parallel_walls(0, 0));
  constexpr std::size_t m = 6, first_pair = 2 * m * m + m;
  ASSERT_EQ(proof.bound.numbers.size(), 3 * m * m + m);
  EXPECT_FALSE(proof.holds_altered(1, -1e-9));
  EXPECT_FALSE(proof.holds_altered(first_pair, -1e-9));
  EXPECT_FALSE(proof.holds_altered(0, 1));
  EXPECT_FALSE(proof.holds_altered(m * m + 3, 10));
  EXPECT_FALSE(proof.holds_altered(2 * m * m, 0));
  EXPECT_FALSE(proof.holds_altered(first_pair, 1e9));
  auto unbounded = proof.bound.numbers;  // without N no motion is bounded
  std::fill(unbounded.begin() + first_pair, unbounded.end(), 0);
  EXPECT_FALSE(proof.holds(proof.bound.factor / 2, unbounded));
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

// The least eigenvalue of F_nn over sym|F_nt|.
double spectral_coefficient(const problems::WedgedProblem& problem) {
  const auto m = static_cast<Eigen::Index>(problem.contact_names.size());
  Eigen::MatrixXd normal(m, m), sizes(m, m);
  const Eigen::Index d = problem.dimension;
  for (Eigen::Index i = 0; i < m; ++i)
    for (Eigen::Index j = 0; j < m; ++j) {
      const Eigen::VectorXd response = problem.compliance.matrix.row(d * i).segment(d * j, d);
      normal(i, j) = response[0];
      sizes(i, j) = response.tail(d - 1).norm();
    }
  sizes = (sizes + sizes.transpose()).eval() / 2;
  return 1 / dense::eigenvalues(sizes, normal).maxCoeff();
}

// P = -I and S = F_nt: the form is negative definite below the spectral coefficient.
TEST(QuadraticProof, IsValidUpToTheSpectralCoefficient) {
  const auto problem = random_problem(3, 9, 5);
  const auto multipliers = spectral(problem);
  const double exact = spectral_coefficient(problem);
  const auto infeasible = [&](double factor) {
    return form_proves_infeasible(problem, std::vector<double>(9, factor), multipliers);
  };
  EXPECT_TRUE(infeasible(exact * (1 - 1e-5)));
  EXPECT_FALSE(infeasible(exact * (1 + 1e-5)));
  EXPECT_GT(bound_of(problem).factor, exact);
}

// A long face with a soft F_nn, for which S with a threshold is far too small.
TEST(QuadraticBound, OfAFaceReachesTheSpectralCoefficient) {
  const auto problem = cantilever_face(32);
  const double spectral = spectral_coefficient(problem);
  const auto with = [&](int rounds) {
    return quadratic_bound(problem, {.enough = 0, .maximum = 1000, .rounds = rounds}).factor;
  };
  EXPECT_GT(with(0), 0.99 * spectral);
  EXPECT_GT(with(4), spectral);
}

TEST(QuadraticProof, CountsTheErrorOfTheCompliance) {
  auto problem = random_problem(2, 9, 5);
  const auto multipliers = spectral(problem);
  const std::vector<double> friction(9, 0.1);
  EXPECT_TRUE(form_proves_infeasible(problem, friction, multipliers));
  problem.compliance.error = 1;
  EXPECT_FALSE(form_proves_infeasible(problem, friction, multipliers));
}

}  // namespace
}  // namespace kusabi::wedged
