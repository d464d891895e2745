// Decisions by valid bounds at every node of structures with any contrast of stiffness.
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "dense.hpp"
#include "nodes/wedged/relaxation/contact_solver.hpp"
#include "tests/nodes/wedged/random_truss.hpp"

namespace kusabi::wedged {
namespace {

using conic::ConicResult;
using conic::Sign;
using numbers::Precise;
using numbers::PreciseMatrix;
using numbers::PreciseVector;

constexpr conic::Tolerances tight{};  // 1e-12

// A problem whose doubles are exact.
problems::WedgedProblem exact_problem(const Eigen::MatrixXd& compliance, int dimension) {
  problems::WedgedProblem problem;
  problem.dimension = dimension;
  problem.compliance.matrix = compliance;
  problem.compliance.stiffness = dense::inverse(compliance);
  for (Eigen::Index i = 0; i < compliance.rows() / dimension; ++i) {
    problem.contact_names.push_back("c" + std::to_string(i));
    problem.friction.push_back(1);
  }
  return problem;
}

struct Count {
  int nodes = 0, feasible = 0, infeasible = 0, escalated = 0;
};

// All leaves and, as inner nodes, those with the last candidate undecided, compared with 104 bits
// from a cold start; and the multipliers in doubles with the F of 104 bits.
template <int D>
void expect_decided(const testing::TrussKind& kind, double mu, double tolerance, Count& count,
                    std::mt19937_64& generator) {
  const auto problem = testing::random_problem(kind, generator).second;
  const std::size_t m = problem.contact_names.size();
  const std::vector<double> friction(m, mu);
  const conic::Tolerances tolerances{.sign = tolerance};
  ContactSolver solver(problem, friction, tolerances);
  const PreciseMatrix scaled = problem.compliance.precise / Precise(solver.unit());
  const double error = problem.compliance.precise_error + 1e-30;
  conic::NodeSolver<D, Precise> precise(scaled, friction, {.sign = 1e-20, .value = 1e-18}, error);
  std::vector<int> each(m);
  std::iota(each.begin(), each.end(), 0);
  const conic::Bounds<D, Precise> bounds(scaled, error, each);
  const std::uint64_t all = (std::uint64_t{1} << m) - 1;
  const std::uint64_t last = std::uint64_t{1} << (m - 1);
  for (std::uint64_t contact = 0; contact <= all; ++contact) {
    for (const std::uint64_t open : {std::uint64_t{0}, last}) {
      if ((contact & open) != 0 || (contact == 0 && open == 0)) continue;
      const std::uint64_t separated = all & ~contact & ~open;
      const conic::StopEarly stop{.when_infeasible = true, .when_feasible = open != 0};
      const ConicResult answer = solver.solve(contact, separated, stop);
      SCOPED_TRACE(::testing::Message()
                   << "U = " << contact << ", R = " << separated << ", mu = " << mu << ": ["
                   << answer.lower << ", " << answer.upper << "]");
      ++count.nodes;
      count.feasible += answer.sign == Sign::feasible;
      count.infeasible += answer.sign == Sign::infeasible;
      count.escalated += answer.precision_level > 0;
      EXPECT_LE(answer.lower, answer.upper);
      EXPECT_TRUE(answer.sign != Sign::unproved || conic::is_within_tolerance(answer, tolerances));
      if (answer.sign == Sign::feasible && open == 0) {
        EXPECT_LE(answer.upper - answer.lower, 1e-3 * answer.lower);
      }
      const ConicResult truth = precise.solve(contact, separated, {true, true});
      EXPECT_LE(truth.lower, answer.upper);
      EXPECT_LE(answer.lower, truth.upper);
      if (answer.sign == Sign::infeasible) {
        const PreciseVector y = solver.multipliers().cast<Precise>();
        PreciseVector pull = PreciseVector::Zero(scaled.rows());
        for (const int i : each) pull += y[i] * scaled.row(D * i).transpose();
        std::vector<int> cones, gaps, contacts;
        for (const int i : each) {
          const auto at = static_cast<unsigned>(i);
          if ((separated >> at & 1) == 0) cones.push_back(i);
          (contact >> at & 1 ? contacts : gaps).push_back(i);
        }
        EXPECT_LT(bounds.above({cones, gaps, contacts, contact}, friction, y, pull), 0);
      }
    }
  }
}

template <int D>
Count expect_all_decided(double contrast, double minimum, double maximum, double tolerance,
                         int problems, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> share(0, 1);
  Count count;
  for (int i = 0; i < problems; ++i) {
    const testing::TrussKind kind{.dimension = D,
                                  .candidates = 1 + i % 4,
                                  .free_nodes = 2 + i % 4 + i % 3,
                                  .contrast = contrast,
                                  .density = 0.4 + 0.1 * (i % 7)};
    expect_decided<D>(kind, minimum * std::pow(maximum / minimum, share(generator)), tolerance,
                      count, generator);
  }
  return count;
}

TEST(PrecisionLevels, DecideEveryNodeInThePlaneAtAnyContrast) {
  unsigned seed = 1;
  for (const double contrast : {1.0, 1e2, 1e4, 1e6, 1e9}) {
    const Count count = expect_all_decided<2>(contrast, 0.1, 10, 1e-12, 20, seed++);
    EXPECT_GT(count.feasible, 20);
    EXPECT_GT(count.infeasible, 100);
  }
}

TEST(PrecisionLevels, DecideEveryNodeInSpaceAtAnyContrast) {
  unsigned seed = 11;
  for (const double contrast : {1.0, 1e3, 1e6, 1e9}) {
    const Count count = expect_all_decided<3>(contrast, 0.1, 10, 1e-12, 12, seed++);
    EXPECT_GT(count.feasible, 20);
    EXPECT_GT(count.infeasible, 20);
  }
}

TEST(PrecisionLevels, EscalateAtMostTwoPercentOfNodes) {
  const Count count = expect_all_decided<2>(1e4, 0.1, 10, 1e-9, 30, 21);
  EXPECT_LT(count.escalated, count.nodes / 50);
}

TEST(PrecisionLevels, DecideNodesAtVerySmallAndVeryLargeFriction) {
  EXPECT_GT(expect_all_decided<2>(1e2, 1e-6, 1e-3, 1e-12, 10, 31).infeasible, 50);
  EXPECT_GT(expect_all_decided<2>(1e2, 1e3, 1e6, 1e-12, 10, 32).feasible, 50);
  EXPECT_GT(expect_all_decided<3>(1e2, 1e-6, 1e-3, 1e-12, 8, 33).infeasible, 50);
  EXPECT_GT(expect_all_decided<3>(1e2, 1e3, 1e6, 1e-12, 8, 34).feasible, 50);
}

TEST(PrecisionLevels, DecideNodesAtEachTolerance) {
  for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
    const Count count = expect_all_decided<2>(1e3, 0.1, 10, tolerance, 8, 41);
    EXPECT_GT(count.infeasible, 20);
  }
}

TEST(ContactSolver, RefusesFrictionOutOfRange) {
  const auto problem = exact_problem(Eigen::MatrixXd::Identity(4, 4), 2);
  for (const double mu : {-1.0, 1e-7, 1e7, std::nan("")})
    EXPECT_THROW(ContactSolver(problem, std::vector<double>{1, mu}, tight), std::invalid_argument);
  ContactSolver solver(problem, std::vector<double>{1, 1}, tight);
  EXPECT_THROW(solver.set_friction(std::vector<double>{1, -1}), std::invalid_argument);
}

// One candidate of F = [a b; b c]: u_n = 0 gives r_t = -a / b for r_n = 1, so t* = mu - a / |b|.
TEST(ContactSolver, DecidesOneCandidateOnBothSidesOfItsCriticalCoefficient) {
  for (const double contrast : {1.0, 1e3, 1e6}) {
    // Dyadic: the quotient is exact.
    Eigen::Matrix2d compliance;
    const double b = 3.0 / 4;
    compliance << b * 8.5, b, b, 2 * contrast;
    const auto problem = exact_problem(compliance, 2);
    for (const double off : {1e-3, 1e-6, 1e-9, 1e-11}) {
      ContactSolver above(problem, std::vector<double>{8.5 + off}, tight);
      ContactSolver below(problem, std::vector<double>{8.5 - off}, tight);
      const ConicResult feasible =
          above.solve(1, 0, {.when_infeasible = true, .when_feasible = false});
      EXPECT_EQ(feasible.sign, Sign::feasible);
      EXPECT_NEAR(feasible.lower, off, 1e-3 * off);
      EXPECT_EQ(below.solve(1, 0, {}).sign, Sign::infeasible);
    }
    ContactSolver at(problem, std::vector<double>{8.5}, tight);
    EXPECT_TRUE(conic::is_within_tolerance(at.solve(1, 0, {}), tight));
  }
}

TEST(ContactSolver, IsInfeasibleEverywhereWithoutFriction) {
  std::mt19937_64 generator(51);
  for (const int dimension : {2, 3}) {
    const auto problem =
        testing::random_problem({.dimension = dimension, .contrast = 1e3}, generator).second;
    ContactSolver solver(problem, std::vector<double>(3, 0), tight);
    for (std::uint64_t contact = 0; contact < 8; ++contact)
      EXPECT_EQ(solver.solve(contact, 7 & ~contact, {}).sign, Sign::infeasible) << contact;
  }
}

// Two candidates that do not interact, [1 1/2; 1/2 1] each, mu = 3 and 0. With r = (r_1, s) at the
// first and 1 - r_1 at the second, t = min(r_1 + s / 2, 3 r_1 - s, 1 - r_1) is largest, 5/8, at
// r_1 = 3/8, s = 1/2. In contact the second has u_n = r_n = 0.
TEST(ContactSolver, HasTheClosedFormOfOneFrictionlessCandidate) {
  Eigen::MatrixXd compliance = Eigen::MatrixXd::Identity(4, 4);
  compliance(0, 1) = compliance(1, 0) = compliance(2, 3) = compliance(3, 2) = 0.5;
  const auto problem = exact_problem(compliance, 2);
  ContactSolver solver(problem, std::vector<double>{3, 0}, tight);
  const conic::StopEarly never{.when_infeasible = false, .when_feasible = false};
  const ConicResult root = solver.solve(0, 0, never);
  EXPECT_NEAR(root.lower, 0.625, 1e-7);
  EXPECT_NEAR(root.upper, 0.625, 1e-7);
  EXPECT_EQ(solver.reaction()[3], 0);
  EXPECT_EQ(solver.solve(0b10, 0b01, {}).sign, Sign::infeasible);
  const auto tie = solver.relative_interior(0b01, 0b10);
  ASSERT_TRUE(tie);
  EXPECT_EQ(tie->loaded, 0b01U);
  EXPECT_EQ(tie->moved, 0U);
}

// Ignored candidates have no influence.
TEST(ContactSolver, IgnoredCandidatesHaveNeitherAReactionNorARow) {
  std::mt19937_64 generator(61);
  for (int repetition = 0; repetition < 10; ++repetition) {
    const auto problem =
        testing::random_problem({.dimension = 2, .candidates = 4, .contrast = 100}, generator)
            .second;
    const std::vector<int> kept{0, 1, 4, 5};  // rows of the candidates 0 and 2
    auto less = exact_problem(problem.compliance.matrix(kept, kept), 2);
    ContactSolver whole(problem, std::vector<double>(4, 2.0), tight);
    ContactSolver part(less, std::vector<double>(2, 2.0), tight);
    const double scale = part.unit() / whole.unit();
    const conic::StopEarly never{.when_infeasible = false, .when_feasible = false};
    for (const auto& [contact, separated] : {std::pair{1, 2}, {2, 1}, {3, 0}, {1, 0}, {0, 0}}) {
      const auto spread = [](int set) {
        return static_cast<std::uint64_t>((set & 1) | (set & 2) << 1);
      };
      const auto one = whole.solve(spread(contact), spread(separated), never, 0b1010);
      const auto other = part.solve(static_cast<std::uint64_t>(contact),
                                    static_cast<std::uint64_t>(separated), never);
      EXPECT_EQ(one.sign, other.sign);
      for (const Eigen::Index row : {2, 3, 6, 7}) EXPECT_EQ(whole.reaction()[row], 0);
      // Gaps have other units, so the values agree where no gap limits t.
      if (separated == 0 && contact == 3 && one.sign == Sign::feasible) {
        EXPECT_NEAR(one.lower, other.lower, 1e-6);
      }
      EXPECT_GT(scale, 0);
    }
  }
}

}  // namespace
}  // namespace kusabi::wedged
