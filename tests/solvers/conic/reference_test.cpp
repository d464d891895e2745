// Comparison with another solver and another formulation: the optimal values computed by
// tests/reference/cvxopt_node_programs.py.
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "solvers/conic/node_solver.hpp"

namespace kusabi::conic {
namespace {

// conelp stops at 1e-9 and NodeSolver at 1e-8; the margin covers the conditioning.
constexpr double agreement = 1e-6;

std::uint64_t mask(const nlohmann::json& list) {
  std::uint64_t set = 0;
  for (const int i : list) set |= std::uint64_t{1} << i;
  return set;
}

template <int D>
void expect_agreement(const nlohmann::json& program) {
  const auto friction = program.at("friction").get<std::vector<double>>();
  const auto rows = program.at("compliance").get<std::vector<std::vector<double>>>();
  const auto size = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd compliance(size, size);
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index j = 0; j < size; ++j)
      compliance(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  NodeSolver<D> solver(compliance, friction);
  const double optimum = program.at("optimum");
  const std::uint64_t contact = mask(program.at("contact"));
  const std::uint64_t separated = mask(program.at("separated"));

  const ConicResult full =
      solver.solve(contact, separated, {.when_infeasible = false, .when_feasible = false});
  EXPECT_NEAR(full.lower, optimum, agreement);
  EXPECT_NEAR(full.upper, optimum, agreement);
  if (std::abs(optimum) > agreement) {
    const Sign sign = optimum > 0 ? Sign::feasible : Sign::infeasible;
    EXPECT_EQ(full.sign, sign);
    EXPECT_EQ(solver.solve(contact, separated).sign, sign);
  }
}

TEST(NodeSolver, AgreesWithAnotherSolverOnTheOriginalForm) {
  std::ifstream file(KUSABI_SOURCE_DIR "/tests/reference/cvxopt_node_programs.json");
  ASSERT_TRUE(file);
  const nlohmann::json programs = nlohmann::json::parse(file);
  ASSERT_EQ(programs.size(), 40U);
  int number = 0;
  for (const auto& program : programs) {
    SCOPED_TRACE(::testing::Message() << "program " << number++);
    if (program.at("dimension") == 2)
      expect_agreement<2>(program);
    else
      expect_agreement<3>(program);
  }
}

}  // namespace
}  // namespace kusabi::conic
