// Degenerate nodes: candidates with reactions and gaps that follow from the structure.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "nodes/wedged/relaxation/contact_solver.hpp"
#include "tests/nodes/wedged/random_truss.hpp"

namespace kusabi::wedged {
namespace {

constexpr conic::Tolerances tight{};

// A truss with another candidate, last in the order, that is always inactive: node c has one bar to
// a support, along its normal, and one to node 0 of the truss, orthogonal to it. u_n of c depends
// on its own r_n alone, and the reactions of the others do not displace it: in contact r_n = 0,
// separated u_n = 0. This holds up to the sixteenth digit, since the directions are at an angle and
// rounded.
problems::Structure with_rod(problems::Structure structure, double angle) {
  const Eigen::Vector2d normal(std::cos(angle), std::sin(angle));
  const Eigen::Vector2d across(-std::sin(angle), std::cos(angle));
  const auto nodes = structure.coordinates.cols();
  structure.coordinates.conservativeResize(2, nodes + 2);
  structure.coordinates.col(nodes) = structure.coordinates.col(0) + 0.7 * across;
  structure.coordinates.col(nodes + 1) = structure.coordinates.col(nodes) - 0.9 * normal;
  structure.node_names.insert(structure.node_names.end(), {"c", "support of c"});
  structure.fixed.push_back({false, false, false});
  structure.fixed.push_back({true, true, true});
  const auto c = static_cast<int>(nodes);
  structure.members.push_back({c, c + 1, 1.0, {}});
  structure.members.push_back({0, c, 2.0, {}});
  structure.contact.push_back({c, normal, std::nullopt, 1.0});
  return structure;
}

// Every pattern of the truss alone is degenerate with c inactive, whether c is in U or in R.
void expect_rest(double angle, unsigned seed) {
  std::mt19937_64 generator(seed);
  int ties = 0;
  for (int repetition = 0; repetition < 12; ++repetition) {
    const auto [structure, bare] = testing::random_problem(
        {.dimension = 2, .candidates = 3, .free_nodes = 4, .contrast = 100}, generator);
    const auto problem = problems::wedged_problem(checked(with_rod(structure, angle)));
    ContactSolver alone(bare, std::vector<double>(3, 1.5), tight);
    ContactSolver solver(problem, std::vector<double>(4, 1.5), tight);
    for (std::uint64_t contact = 1; contact < 8; ++contact) {
      const std::uint64_t separated = 7 & ~contact;
      const auto truth = alone.solve(contact, separated, {});
      if (truth.sign != conic::Sign::feasible || truth.lower < 1e-5) continue;
      for (const bool touches : {true, false}) {
        ++ties;
        SCOPED_TRACE(::testing::Message() << "repetition " << repetition << ", U = " << contact
                                          << (touches ? " and c" : ""));
        const std::uint64_t with = contact | (touches ? 8U : 0U);
        const auto answer = solver.solve(with, 15 & ~with, {});
        EXPECT_TRUE(conic::is_within_tolerance(answer, tight));
        const auto found = solver.relative_interior(with, 15 & ~with);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->loaded, contact);
        EXPECT_EQ(found->moved, separated);
        // The point itself.
        double sum = 0;
        for (int i = 0; i < 4; ++i) sum += solver.normal_reaction(i);
        EXPECT_NEAR(sum, 1, 1e-12);
        for (int i = 0; i < 3; ++i) {
          const bool loaded = (contact >> static_cast<unsigned>(i) & 1) != 0;
          EXPECT_EQ(solver.normal_reaction(i) > 1e-9, loaded);
          EXPECT_EQ(solver.normal_displacement(i) > 1e-9, !loaded);
        }
        EXPECT_NEAR(solver.normal_displacement(3), 0, 1e-12);
      }
    }
  }
  EXPECT_GT(ties, 10);
}

TEST(RelativeInterior, OfExactlyDegenerateNodesHasTheInactiveCandidate) {
  expect_rest(0, 1);
}

TEST(RelativeInterior, OfNodesDegenerateUpToRoundingHasTheInactiveCandidate) {
  expect_rest(0.3, 2);
  expect_rest(1.1, 3);
  expect_rest(2.9, 4);
}

TEST(RelativeInterior, IsTheSamePointForEitherSideOfInactiveCandidates) {
  Eigen::MatrixXd compliance = Eigen::MatrixXd::Identity(8, 8);
  compliance(0, 1) = compliance(1, 0) = 0.5;
  problems::WedgedProblem problem;
  problem.dimension = 2;
  problem.compliance.matrix = problem.compliance.stiffness = compliance;
  problem.contact_names.assign(4, "c");
  ContactSolver solver(problem, std::vector<double>(4, 3.0), tight);
  for (std::uint64_t resting = 0; resting < 16; resting += 2) {
    const auto found = solver.relative_interior(1 | resting, 14 & ~resting);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->loaded, 1U);
    EXPECT_EQ(found->moved, 0U);
  }
}

TEST(RelativeInterior, ExistsForDegenerateNodesOnly) {
  Eigen::MatrixXd compliance(2, 2);
  compliance << 1, 0.5, 0.5, 1;
  problems::WedgedProblem problem;
  problem.dimension = 2;
  problem.compliance.matrix = problem.compliance.stiffness = compliance;
  problem.contact_names.assign(1, "c");
  ContactSolver feasible(problem, std::vector<double>{3.0}, tight);
  EXPECT_FALSE(feasible.relative_interior(1, 0));
  ContactSolver infeasible(problem, std::vector<double>{1.0}, tight);
  EXPECT_FALSE(infeasible.relative_interior(1, 0));
}

// At its own coefficient, t* = mu - F_nn / |F_nt| = 0, a candidate slides with a reaction.
TEST(RelativeInterior, HasALoadedCandidateAtItsCriticalCoefficient) {
  Eigen::MatrixXd compliance(2, 2);
  compliance << 1, 0.5, 0.5, 1;
  problems::WedgedProblem problem;
  problem.dimension = 2;
  problem.compliance.matrix = problem.compliance.stiffness = compliance;
  problem.contact_names.assign(1, "c");
  ContactSolver solver(problem, std::vector<double>{2.0}, tight);
  const auto found = solver.relative_interior(1, 0);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->loaded, 1U);
  EXPECT_EQ(found->moved, 0U);
}

}  // namespace
}  // namespace kusabi::wedged
