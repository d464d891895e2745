// Unconstrained bodies: u = F r + G alpha solves K^0 u = r for all reactions in equilibrium,
// independently of the grounding springs.
#include <random>
#include <vector>

#include <Eigen/Core>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dense.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/structure/assembly/solid_element.hpp"
#include "problems/structure/model/truss.hpp"
#include "problems/wedged/problem_block.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "problems/wedged/whole_structure.hpp"
#include "tests/problems/trusses.hpp"

namespace kusabi::problems {
namespace {

/// A block of 4 x 3 elements in a groove: its lower vertices touch two slopes.
Structure block(const std::string& more = "") {
  return read_structure(R"(
name = "block in a groove"
dimension = 2
units = { length = "m", force = "kN" }
[[mesh]]
name = "b"
corners = [[100, 0], [102, 0], [102, 1], [100, 1.5]]
divisions = [4, 3]
E = 3
nu = 0.25
thickness = 1
plane = "strain"
[[contact]]
nodes = ["b.left"]
normal = [0.9, 0.3]
[[contact]]
nodes = ["b.right"]
normal = [-1, 0.25]
)" + more,
                        "block");
}

Eigen::VectorXd in_equilibrium(const WedgedProblem& problem, std::mt19937& random) {
  const Eigen::VectorXd any = test::random_vector(problem.compliance.matrix.rows(), random);
  const Eigen::MatrixXd& g = problem.modes.matrix;
  return any - g * dense::least_squares(g, any, 1e-12);
}

std::vector<double> list(const Eigen::VectorXd& vector) {
  return {vector.begin(), vector.end()};
}

/// K^0 of the whole structure, all nodes free.
Eigen::MatrixXd whole_stiffness(Structure structure) {
  for (auto& axes : structure.fixed) axes = {};
  const FreeDegrees degrees = free_degrees(structure);
  return Eigen::MatrixXd(truss_stiffness(structure, degrees, member_stiffnesses(structure))) +
         Eigen::MatrixXd(element_stiffness(structure, degrees));
}

Eigen::VectorXd global_forces(const Structure& structure, const WedgedProblem& problem,
                              const Eigen::VectorXd& r) {
  const Eigen::Index d = structure.dimension;
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(structure.coordinates.size());
  for (std::size_t i = 0; i < structure.contact.size(); ++i) {
    forces.segment(d * structure.contact[i].node, d) +=
        problem.frames[i] * r.segment(d * static_cast<Eigen::Index>(i), d);
  }
  return forces;
}

TEST(UnconstrainedBodies, SatisfyTheEquationOfTheWholeStiffness) {
  const Structure structure = block();
  const auto problem = wedged_problem(checked(structure));
  ASSERT_EQ(problem.modes.matrix.cols(), 3);
  ASSERT_EQ(problem.modes.bodies.size(), 1U);
  EXPECT_EQ(problem.modes.bodies[0].motions, "can move along x and y and turn");
  const WholeStructure whole(checked(structure), problem);
  std::mt19937 random(1);
  const Eigen::MatrixXd stiffness = whole_stiffness(structure);
  for (int trial = 0; trial < 5; ++trial) {
    const Eigen::VectorXd r = in_equilibrium(problem, random);
    const Eigen::VectorXd u =
        problem.compliance.matrix * r + problem.modes.matrix * test::random_vector(3, random);
    const auto state = whole.under(list(r), list(u));
    const Eigen::VectorXd all = state.displacements.reshaped();
    EXPECT_LE((stiffness * all - global_forces(structure, problem, r)).norm(), 1e-11 * r.norm());
    for (std::size_t i = 0; i < structure.contact.size(); ++i) {
      const Eigen::VectorXd own =
          problem.frames[i].transpose() * state.displacements.col(structure.contact[i].node);
      EXPECT_LE((own - u.segment(2 * static_cast<Eigen::Index>(i), 2)).norm(), 1e-11 * u.norm());
    }
    EXPECT_TRUE(state.reactions.isZero(0.0));
    EXPECT_LE(state.imbalance, 1e-14);
  }
}

TEST(UnconstrainedBodies, HaveIndependentRigidBodyModes) {
  const Structure structure = block();
  const auto problem = wedged_problem(checked(structure));
  const Eigen::MatrixXd gram = problem.modes.matrix.transpose() * problem.modes.matrix;
  EXPECT_LE((gram - Eigen::MatrixXd(gram.diagonal().asDiagonal())).norm(), 1e-14 * gram.norm());
  EXPECT_THAT(problem.modes.precise_error, testing::AllOf(testing::Gt(0), testing::Lt(1e-26)));
  const auto all = all_candidates(problem);
  EXPECT_EQ(problem.blocks, std::vector{all});
  const Eigen::VectorXd largest = problem.modes.matrix.cwiseAbs().colwise().maxCoeff().transpose();
  for (const double size : largest)
    EXPECT_THAT(size, testing::AllOf(testing::Gt(0.4), testing::Le(1)));
}

// The same body with other springs: the difference is a rigid-body mode.
TEST(UnconstrainedBodies, DoNotDependOnTheGroundingSprings) {
  const auto problem = wedged_problem(checked(block()));
  const auto sprung = wedged_problem(checked(block(R"(
[[springs]]
nodes = ["b.0,0", "b.4,0"]
axes = ["y"]
stiffness = 0.3
[[springs]]
nodes = ["b.2,3"]
axes = ["x"]
stiffness = 7
)")));
  EXPECT_EQ(sprung.modes.matrix.cols(), 0);
  EXPECT_TRUE(sprung.modes.bodies.empty());
  EXPECT_NE(problem.provenance.fingerprint, sprung.provenance.fingerprint);
  std::mt19937 random(2);
  const Eigen::VectorXd r = in_equilibrium(problem, random);
  const Eigen::VectorXd difference = (problem.compliance.matrix - sprung.compliance.matrix) * r;
  const Eigen::MatrixXd& g = problem.modes.matrix;
  const Eigen::VectorXd rigid = g * dense::least_squares(g, difference, 1e-12);
  EXPECT_GT((sprung.compliance.matrix * r).norm(), 1e-3 * r.norm());
  EXPECT_LE((difference - rigid).norm(), 1e-12 * (sprung.compliance.matrix * r).norm());
}

// A bar along x on a spring: 1/F = 1/(1/k + L/EA) along x.
TEST(Springs, InSeriesWithABarAddTheirCompliances) {
  const auto structure = read_structure(R"(
name = "bar on springs"
dimension = 2
units = { length = "m", force = "kN" }
[nodes]
a = [0, 0]
b = [2, 0]
[[members]]
EA = 6
between = [["a", "b"]]
[[supports]]
nodes = ["a"]
fixed = ["y"]
[[springs]]
nodes = ["a"]
axes = ["x"]
stiffness = 0.5
[[springs]]
nodes = ["b"]
axes = ["y"]
stiffness = 4
[[contact]]
nodes = ["b"]
normal = [-1, 0]
)",
                                        "bar");
  const auto problem = wedged_problem(structure);
  EXPECT_EQ(problem.modes.matrix.cols(), 0);
  EXPECT_DOUBLE_EQ(problem.compliance.matrix(0, 0), 1 / 0.5 + 2.0 / 6);
  EXPECT_DOUBLE_EQ(problem.compliance.matrix(1, 1), 0.25);
  EXPECT_DOUBLE_EQ(problem.compliance.matrix(0, 1), 0);
  const WholeStructure whole(structure, problem);
  const auto state = whole.under(std::vector<double>{3, 0});  // 3 along -x
  EXPECT_DOUBLE_EQ(state.displacements(0, 0), -6);
  EXPECT_DOUBLE_EQ(state.reactions(0, 0), 3);
  EXPECT_LE(state.imbalance, 1e-15);
  EXPECT_TRUE(whole.is_supported(1));
}

TEST(UnconstrainedBodies, AreBlocksWithTheirOwnModesIfDecoupled) {
  const auto problem = wedged_problem(read_structure(R"(
name = "two bars in the air"
dimension = 2
units = { length = "m", force = "kN" }
[nodes]
a = [0, 0]
b = [2, 0]
c = [5, 0]
d = [5, 1]
[[members]]
EA = 6
between = [["a", "b"], ["c", "d"]]
[[contact]]
nodes = ["a", "c"]
normal = [0, 1]
[[contact]]
nodes = ["b", "d"]
normal = [-1, 0]
)",
                                                     "bars"));
  ASSERT_EQ(problem.blocks.size(), 2U);
  EXPECT_EQ(problem.modes.matrix.cols(), 6);
  for (const auto& each : problem.blocks) {
    const auto part = block_problem(problem, each);
    EXPECT_EQ(part.modes.matrix.rows(), 4);
    EXPECT_EQ(part.modes.matrix.cols(), 3);
    EXPECT_EQ(part.modes.precise.cols(), 3);
  }
}

// A pendulum with its tip as the only candidate has the rotation as a mode; a bar with one
// candidate has no rotation among its modes.
TEST(UnconstrainedBodies, HaveOnlyModesThatMoveCandidates) {
  const auto one = wedged_problem(read_structure(R"(
name = "a bar"
dimension = 2
units = { length = "m", force = "kN" }
[nodes]
a = [0, 0]
b = [2, 1]
[[members]]
EA = 6
between = [["a", "b"]]
[[contact]]
nodes = ["b"]
normal = [-1, 0]
)",
                                                 "bar"));
  EXPECT_EQ(one.modes.matrix.cols(), 2);
  EXPECT_EQ(one.modes.bodies[0].motions, "can move along x and y and turn");
}

}  // namespace
}  // namespace kusabi::problems
