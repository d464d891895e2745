// Bodies with given stiffness: beams by closed forms, and the same structure with its bars and
// elements replaced by a matrix.
#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "problems/limit/limit_problem.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "problems/wedged/whole_structure.hpp"
#include "tests/problems/bodies.hpp"
#include "tests/problems/trusses.hpp"

namespace kusabi::problems {
namespace {

using testing::HasSubstr;

/// Rounding of sums in doubles in the matrix; the structures have condition numbers of at most 1e6.
constexpr double matrix_rounding = 1e-9;

Eigen::SparseMatrix<double> sparse(const Eigen::MatrixXd& matrix) {
  return matrix.sparseView();
}

/// Euler-Bernoulli, EI = 1: transverse displacement and rotation of both ends.
Eigen::Matrix4d bending(double length) {
  const double l = length;
  const Eigen::Matrix4d k{{12, 6 * l, -12, 6 * l},
                          {6 * l, 4 * l * l, -6 * l, 2 * l * l},
                          {-12, -6 * l, 12, -6 * l},
                          {6 * l, 2 * l * l, -6 * l, 4 * l * l}};
  return k / (l * l * l);
}

/// A cantilever along x of `count` elements of length 1, EI = EA = 1, clamped at its first node by
/// its supports and its first rotation; rows x, y, rotation of each node.
Structure cantilever(int count) {
  Structure structure = test::empty_structure(2);
  for (int node = 0; node <= count; ++node) test::add_node(structure, Eigen::Vector2d(node, 0));
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(3 * (count + 1), 3 * (count + 1));
  for (int e = 0; e < count; ++e) {
    const std::vector<int> rows{3 * e + 1, 3 * e + 2, 3 * e + 4, 3 * e + 5};
    matrix(rows, rows) += bending(1);
    const std::vector<int> along{3 * e, 3 * e + 3};
    matrix(along, along) += Eigen::Matrix2d{{1, -1}, {-1, 1}};
  }
  std::vector<int> kept;
  Superelement beam;
  for (int row = 0; row < 3 * (count + 1); ++row) {
    if (row == 2) continue;
    kept.push_back(row);
    beam.rows.push_back({row % 3 == 2 ? -1 : row / 3, row % 3});
  }
  beam.stiffness = sparse(matrix(kept, kept));
  structure.superelements.push_back(beam);
  structure.fixed[0] = {true, true, false};
  structure.contact = {{count, Eigen::Vector2d(0, 1), std::nullopt}};  // t = (1, 0)
  return structure;
}

TEST(Superelement, OfABeamAgreesWithBeamTheory) {
  for (const int count : {1, 2, 7}) {
    const double l = count;
    const WedgedProblem problem = wedged_problem(checked(cantilever(count)));
    EXPECT_NEAR(problem.compliance.matrix(0, 0), l * l * l / 3, matrix_rounding * l * l * l);
    EXPECT_NEAR(problem.compliance.matrix(1, 1), l, matrix_rounding * l);
    EXPECT_EQ(problem.compliance.matrix(0, 1), 0);
  }
}

// The clamp takes the force; its moment acts on a rotation without support reaction.
TEST(Superelement, TransmitsForcesToTheSupports) {
  const Structure structure = cantilever(3);
  const WholeStructure whole(checked(structure), wedged_problem(checked(structure)));
  const auto state = whole.under(std::vector<double>{2, 5}, std::vector<double>{18, 15});
  EXPECT_NEAR(state.reactions(1, 0), -2, matrix_rounding);
  EXPECT_NEAR(state.reactions(0, 0), -5, matrix_rounding);
  EXPECT_NEAR(state.displacements(1, 3), 18, 1e-7);
}

// With pairs, constraints, inclined supports and rollers, some of which are in the matrix as well.
TEST(Superelement, IsEquivalentToItsBarsAndElements) {
  std::mt19937 bits(5);  // NOLINT(cert-msc32-c,cert-msc51-cpp): repeatable on purpose
  for (int round = 0; round < 6; ++round) {
    const Structure structure = test::random_bodies(round % 2 == 0 ? 2 : 3, bits);
    const WedgedProblem expected = wedged_problem(checked(structure));
    const WedgedProblem found = wedged_problem(checked(test::with_a_matrix(structure)));
    EXPECT_TRUE(found.compliance.matrix.isApprox(expected.compliance.matrix, matrix_rounding));
    EXPECT_NE(found.provenance.fingerprint, expected.provenance.fingerprint);
    EXPECT_LE(found.compliance.precise_error, 1e-15);
  }
}

TEST(Superelement, HasTheBlocksOfItsMatrix) {
  Structure structure = cantilever(1);
  EXPECT_EQ(wedged_problem(checked(structure)).blocks.size(), 1U);
  structure.fixed[0] = {};
  structure.superelements.clear();
  Superelement two;  // a spring at each node
  two.rows = {{0, 0}, {0, 1}, {1, 0}, {1, 1}};
  two.stiffness = sparse(Eigen::Matrix4d::Identity());
  structure.superelements.push_back(two);
  structure.contact.push_back({0, Eigen::Vector2d(0, 1), std::nullopt});
  EXPECT_EQ(wedged_problem(checked(structure)).blocks.size(), 2U);
}

std::string error_of(const Structure& structure) {
  try {
    wedged_problem(checked(structure));
  } catch (const support::InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Superelement, IsRefusedIfItIsUnconstrained) {
  Structure structure = cantilever(2);
  structure.fixed[0] = {true, false, false};
  EXPECT_THAT(error_of(structure), HasSubstr("can move: a [[stiffness]] resists it only by"));
  // A stiffness due to rounding does not constrain a body.
  structure.superelements[0].stiffness *= 1 + 1e-13;
  structure.superelements[0].stiffness.coeffRef(1, 1) *= 1 + 1e-13;
  structure.superelements[0].rounding = 1e-12;
  EXPECT_THAT(error_of(structure), HasSubstr("can move: a [[stiffness]] resists it only by"));
  structure.superelements[0].rounding = 0;
  structure.springs.push_back({2, 1, 1e-3});
  structure.springs.push_back({1, 1, 1e-3});
  EXPECT_EQ(error_of(structure), "no error");
}

TEST(Superelement, IsRefusedIfARotationIsNotPrevented) {
  Structure structure = cantilever(1);
  Superelement& beam = structure.superelements[0];
  beam.rows.push_back({-1, 0});
  beam.rows.push_back({-1, 0});
  const auto size = static_cast<Eigen::Index>(beam.rows.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
  matrix.topLeftCorner(size - 2, size - 2) = Eigen::MatrixXd(beam.stiffness);
  matrix.bottomRightCorner(2, 2) << 1, -1, -1, 1;
  beam.stiffness = sparse(matrix);
  EXPECT_THAT(error_of(structure),
              HasSubstr("an internal unknown of a stiffness, such as a rotation"));
}

TEST(Superelement, IsRefusedIfItIsNoStiffness) {
  const Structure structure = cantilever(1);
  auto wrong = structure;
  wrong.superelements[0].stiffness.coeffRef(3, 3) = -1;
  EXPECT_THAT(error_of(wrong), HasSubstr("entry (4, 4) of the stiffness is -1"));
  wrong = structure;
  wrong.superelements[0].stiffness.coeffRef(0, 2) = -1.5;
  EXPECT_THAT(error_of(wrong), HasSubstr("expected a symmetric matrix"));
  wrong.superelements[0].stiffness.coeffRef(2, 0) = -1.5;
  EXPECT_THAT(error_of(wrong), HasSubstr("the stiffness has a negative eigenvalue"));
  wrong = structure;
  wrong.superelements[0].rows.pop_back();
  EXPECT_THAT(error_of(wrong), HasSubstr("the stiffness is 5 x 5; expected 4 x 4"));
  wrong = structure;
  wrong.superelements[0].rows[0] = wrong.superelements[0].rows[2];
  EXPECT_THAT(error_of(wrong), HasSubstr("two rows of \"node 1\" along x"));
}

TEST(Superelement, IsRefusedByLimitAnalysis) {
  try {
    limit_problem(checked(cantilever(1)));
    FAIL() << "limit analysis of a matrix";
  } catch (const support::InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("a stiffness of another program has no yield force"));
  }
}

}  // namespace
}  // namespace kusabi::problems
