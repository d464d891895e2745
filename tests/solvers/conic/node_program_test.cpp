// Tests of the standard form: it is equivalent to the node program, and bad input is refused.
#include "solvers/conic/node_program.hpp"

#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/solvers/conic/contact_problem.hpp"

namespace kusabi::conic {
namespace {

using testing::ContactProblem;
using testing::contains;
using testing::Masks;

// Sums of about a dozen products of order one.
constexpr double rounding = 1e-13;

template <int D>
void expect_same_rows_and_levels() {
  std::mt19937_64 generator(3);
  for (int m = 1; m <= 6; ++m) {
    const ContactProblem problem = testing::random_problem(D, m, 0.1, 3, generator);
    const Masks masks = testing::random_masks(m, generator);
    NodeProgram<D> program(problem.compliance, problem.friction);
    program.select(masks.first, masks.second);
    const auto count = static_cast<Eigen::Index>(program.cones().size());

    // Any x determines r and t, and row i of A x - b is u_n - t, or u_n on U.
    const PackedColumns<> matrix = program.matrix();
    ConePoints<D> x = ConePoints<D>::Zero(matrix.stride, D);
    x.topRows(count).setRandom();
    Eigen::VectorXd r(D * m);
    program.reaction(x, r);
    const double t = program.level(x.col(0).sum());
    const Eigen::VectorXd u = problem.compliance * r;
    Eigen::VectorXd rows(matrix.rows);
    product(matrix, x.data(), rows.data());
    rows -= program.right_side();
    double sum = 0;
    for (int i = 0; i < m; ++i) {
      sum += r[D * i];
      EXPECT_NEAR(rows[i], u[D * i] - (contains(masks.first, i) ? 0 : t), rounding * m);
      if (contains(masks.second, i)) {
        EXPECT_EQ(r.segment(D * i, D).norm(), 0);
      }
    }
    EXPECT_NEAR(sum, 1, rounding);
    // The cone of x is the friction cone relaxed by t.
    for (Eigen::Index c = 0; c < count; ++c) {
      const int i = program.cones()[static_cast<std::size_t>(c)];
      const double mu = problem.friction[static_cast<std::size_t>(i)];
      EXPECT_NEAR(mu * (x(c, 0) - x.row(c).tail(D - 1).norm()),
                  mu * r[D * i] - r.segment(D * i + 1, D - 1).norm() - t, rounding);
    }
    double level = program.friction_level(r);
    for (const int j : program.gap_rows())
      level = std::min(level, program.normal_displacements(r)[j]);
    EXPECT_NEAR(level, testing::level(problem, masks, r), rounding * m);
  }
}

TEST(NodeProgram, RowsAreTheNormalDisplacementsInThePlane) {
  expect_same_rows_and_levels<2>();
}
TEST(NodeProgram, RowsAreTheNormalDisplacementsInSpace) {
  expect_same_rows_and_levels<3>();
}

TEST(NodeProgram, DiscrepancyIsTheNegativeGapOfCandidatesInContact) {
  const Eigen::MatrixXd compliance = Eigen::MatrixXd::Identity(6, 6);
  NodeProgram<2> program(compliance, std::vector<double>{1, 1, 1});
  program.select(0b001, 0, 0b100);
  Eigen::VectorXd r(6);
  r << 0.25, 0, 0.75, 0, 0, 0;
  EXPECT_EQ(program.normal_displacements(r).head(3), Eigen::Vector3d(0.25, 0.75, 0));
  EXPECT_EQ(program.discrepancy().head(3), Eigen::Vector3d(-0.25, 0, 0));
}

TEST(NodeProgram, PullIsTheDisplacementUnderNormalForces) {
  std::mt19937_64 generator(7);
  const ContactProblem problem = testing::random_problem(3, 5, 0.1, 3, generator);
  NodeProgram<3> program(problem.compliance, problem.friction);
  Eigen::VectorXd y = Eigen::VectorXd::Zero(8);
  y.head(5).setRandom();
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(15);
  for (int i = 0; i < 5; ++i) forces[3 * i] = y[i];
  EXPECT_LE((program.pull(y).head(15) - problem.compliance * forces).norm(), rounding);
}

TEST(NodeProgram, RefusesInvalidData) {
  const Eigen::MatrixXd good = Eigen::MatrixXd::Identity(4, 4);
  using Frictions = std::vector<double>;
  EXPECT_NO_THROW(NodeProgram<2>(good, Frictions({1, 1})));
  EXPECT_THROW(NodeProgram<2>(good, Frictions({1})), std::invalid_argument);
  EXPECT_THROW(NodeProgram<3>(good, Frictions({1, 1})), std::invalid_argument);
  EXPECT_NO_THROW(NodeProgram<2>(good, Frictions({1, 0})));
  EXPECT_THROW(NodeProgram<2>(good, Frictions({1, -1})), std::invalid_argument);
  EXPECT_THROW(NodeProgram<2>(good, Frictions({1, 1e-7})), std::invalid_argument);
  EXPECT_THROW(NodeProgram<2>(good, Frictions({1, 1e7})), std::invalid_argument);
  EXPECT_THROW(NodeProgram<2>(good, Frictions({1, std::nan("")})), std::invalid_argument);
  EXPECT_THROW(NodeProgram<2>(Eigen::MatrixXd(0, 0), Frictions()), std::invalid_argument);
  EXPECT_NO_THROW(NodeProgram<2>(Eigen::MatrixXd::Identity(130, 130), Frictions(65, 1.0)));
  Eigen::MatrixXd bad = good;
  bad(0, 1) = 0.5;
  EXPECT_THROW(NodeProgram<2>(bad, Frictions({1, 1})), std::invalid_argument);
  bad = good;
  bad(2, 2) = -1;
  EXPECT_THROW(NodeProgram<2>(bad, Frictions({1, 1})), std::invalid_argument);
}

TEST(NodeProgram, RefusesInvalidSets) {
  NodeProgram<2> program(Eigen::MatrixXd::Identity(4, 4), std::vector<double>{1, 1});
  EXPECT_THROW(program.select(0b01, 0b01), std::invalid_argument);
  EXPECT_THROW(program.select(0b100, 0), std::invalid_argument);
  EXPECT_THROW(program.select(0b01, 0, 0b01), std::invalid_argument);
  EXPECT_THROW(program.select(0, 0, 0b100), std::invalid_argument);
  EXPECT_THROW(program.select(0, std::uint64_t{1} << 63), std::invalid_argument);
}

}  // namespace
}  // namespace kusabi::conic
