// Structures on which an earlier solver stalled, with results in 60-digit arithmetic.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "nodes/wedged/relaxation/contact_solver.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {
namespace {

problems::WedgedProblem problem_of(const std::string& name) {
  const std::string path = KUSABI_SOURCE_DIR "/tests/nodes/wedged/cases/" + name + ".toml";
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return problems::wedged_problem(problems::read_structure(text.str(), path));
}

struct Leaves {
  int feasible = 0, undecided = 0;
  double nearest = std::numeric_limits<double>::infinity();  // distance of the true value from the
                                                             // nearest feasible margin
};

Leaves leaves(const problems::WedgedProblem& problem, double mu, double truth,
              double tolerance = 1e-12) {
  const std::size_t m = problem.contact_names.size();
  const conic::Tolerances tolerances{.sign = tolerance};
  std::vector<double> friction = problem.friction;
  for (double& factor : friction) factor *= mu;
  ContactSolver solver(problem, friction, tolerances);
  const std::uint64_t all = (std::uint64_t{1} << m) - 1;
  Leaves result;
  for (std::uint64_t contact = 0; contact <= all; ++contact) {
    const auto answer =
        solver.solve(contact, all & ~contact, {.when_infeasible = true, .when_feasible = false});
    if (answer.sign == conic::Sign::unproved && !conic::is_within_tolerance(answer, tolerances))
      ++result.undecided;
    if (answer.sign != conic::Sign::feasible) continue;
    ++result.feasible;
    EXPECT_LE(answer.upper - answer.lower, 1e-3 * answer.upper);
    if (std::abs(answer.lower - truth) < std::abs(result.nearest - truth))
      result.nearest = answer.lower;
  }
  return result;
}

TEST(ContactSolverCases, HaveMarginsRightToThreeDigits) {
  const struct {
    const char* name;
    double mu, margin, digits;
  } cases[] = {{"undecided_contrast6_493", 0.7261972342575947, 9.32e-5, 0.005e-5},
               {"undecided_10073", 1.6914265214745143, 8.98e-6, 0.005e-6},
               {"false_lower_101", 1.13815, 6.67e-5, 0.005e-5},
               {"margin_low_t1_3_20059", 0.8176783003384308, 4.8e-4, 0.05e-4}};
  for (const auto& test : cases) {
    SCOPED_TRACE(test.name);
    const Leaves found = leaves(problem_of(test.name), test.mu, test.margin);
    EXPECT_EQ(found.undecided, 0);
    EXPECT_NEAR(found.nearest, test.margin, test.digits);
  }
}

// The last digit of the true value is known; coefficients beyond it on either side are decided.
TEST(ContactSolverCases, AreDecidedOnBothSidesOfACriticalCoefficient) {
  const struct {
    const char* name;
    double infeasible, feasible;
  } cases[] = {{"critical_wrong_1e6", 560.546040215, 560.546040225},
               {"critical_wrong_low", 107.780635, 107.780645}};
  for (const auto& test : cases) {
    SCOPED_TRACE(test.name);
    const auto problem = problem_of(test.name);
    EXPECT_EQ(leaves(problem, test.infeasible, 0).feasible, 0);
    EXPECT_EQ(leaves(problem, test.infeasible, 0).undecided, 0);
    EXPECT_EQ(leaves(problem, test.feasible, 0).feasible, 1);
  }
}

TEST(ContactSolverCases, AreDecidedAtATightTolerance) {
  const auto problem = problem_of("tolerance_undecided");
  for (const double tolerance : {1e-10, 1e-12})
    EXPECT_EQ(leaves(problem, 0.51200526, 0, tolerance).undecided, 0);
}

// From infeasible to feasible coefficients, through the critical one.
TEST(ContactSolverCases, AreDecidedNearACriticalCoefficient) {
  for (const char* name : {"undecided_lowcond_88", "false_lower_62"}) {
    SCOPED_TRACE(name);
    const auto problem = problem_of(name);
    double infeasible = 1e-3, feasible = 1e3;
    for (int step = 0; step < 45; ++step) {
      const double mu = std::sqrt(infeasible * feasible);
      const Leaves found = leaves(problem, mu, 0);
      EXPECT_EQ(found.undecided, 0) << "mu = " << mu;
      (found.feasible > 0 ? feasible : infeasible) = mu;
    }
    EXPECT_LT(feasible, 1e3);
  }
}

}  // namespace
}  // namespace kusabi::wedged
