// Enclosures of stiffness matrices of other programs: consistent with the solver, proved, and
// distinguished from others.
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nodes/evidence/verified_structure.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "searched.hpp"
#include "tests/problems/bodies.hpp"

namespace kusabi::verify {
namespace {

problems::Structure random_matrix(int draw, std::mt19937& bits) {
  return problems::test::with_a_matrix(problems::test::random_bodies(2 + draw % 2, bits));
}

// With an internal unknown, such as a rotation, between the first row and the last.
problems::Structure with_an_own_unknown(problems::Structure structure) {
  auto& [rows, stiffness, rounding] = structure.superelements.front();
  const auto n = stiffness.rows();
  const double size = stiffness.coeff(0, 0);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + 1, n + 1);
  matrix.topLeftCorner(n, n) = Eigen::MatrixXd(stiffness);
  matrix(n, n) = 2 * size;
  for (const Eigen::Index row : {Eigen::Index{0}, n - 1}) {
    matrix(row, row) += size;
    matrix(row, n) -= size;
    matrix(n, row) -= size;
  }
  stiffness = matrix.sparseView();
  rows.push_back({-1, 0});
  return structure;
}

TEST(GivenStiffness, IsEnclosedNearTheStiffnessOfTheSolver) {
  std::mt19937 bits(8);
  for (int draw = 0; draw < 10; ++draw) {
    SCOPED_TRACE(draw);
    auto structure = random_matrix(draw, bits);
    if (draw > 5) structure = with_an_own_unknown(structure);
    expect_same_stiffness(structure);
  }
}

TEST(GivenStiffness, HasCertificatesThatAreProvedForItAlone) {
  std::mt19937 bits(9);
  for (int draw = 0; draw < 4; ++draw) {
    SCOPED_TRACE(draw);
    auto structure = with_an_own_unknown(random_matrix(draw, bits));
    auto own = evidence::verified_structure(structure);
    const auto text = searched(problems::wedged_problem(checked(structure)), 0.6).text();
    EXPECT_THAT(verdict(text, &own).refusals, testing::IsEmpty());
    for (auto& entry : own.given.front().entries) entry.value *= 1.001;
    EXPECT_THAT(verdict(text, &own).refusals,
                testing::ElementsAre(
                    testing::HasSubstr("K of the certificate is not that of the structure")));
  }
}

}  // namespace
}  // namespace kusabi::verify
