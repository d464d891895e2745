// Tests of the benchmark format: the program of a node as a file, against one written by hand.
// tests/run/export_command_test.cpp reads the files with other solvers.
#include "solvers/conic/benchmark_format.hpp"

#include <algorithm>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "solvers/conic/node_solver.hpp"
#include "tests/solvers/conic/contact_problem.hpp"

namespace kusabi::conic {
namespace {

std::string written(const ConeProgram& program) {
  std::ostringstream out;
  write_benchmark_format(out, program, std::vector<std::string>{"a comment"});
  return out.str();
}

// Three candidates in the plane: the first in contact, the second without friction, the third
// separated.
TEST(BenchmarkFormat, IsTheProgramOfTheNode) {
  Eigen::MatrixXd compliance(6, 6);
  compliance << 2, 0, 0.5, 0, 0, 0,  //
      0, 2, 0, 0, 0, 0,              //
      0.5, 0, 1, 0.25, 0, 0,         //
      0, 0, 0.25, 1, 0, 0,           //
      0, 0, 0, 0, 4, 0,              //
      0, 0, 0, 0, 0, 4;
  const std::vector<double> friction{0.75, 0, 0.5};
  EXPECT_EQ(written(node_cone_program(compliance, friction, 0b001, 0b100)),
            "# a comment\n"
            "VER\n1\n\n"
            "OBJSENSE\nMAX\n\n"
            "VAR\n7 3\nF 3\nL= 3\nF 1\n\n"
            "CON\n7 4\nL= 2\nL+ 2\nQ 2\nL+ 1\n\n"
            "OBJACOORD\n1\n6 1\n\n"
            "ACOORD\n16\n"
            "0 0 1\n0 2 1\n0 4 1\n"
            "1 0 2\n1 2 0.5\n"
            "2 0 0.5\n2 2 1\n2 3 0.25\n2 6 -1\n"
            "3 4 4\n3 6 -1\n"
            "4 0 0.75\n4 6 -1\n5 1 1\n"
            "6 2 1\n6 6 -1\n\n"
            "BCOORD\n1\n0 -1\n\n");
}

// Largest violation of the cones by the numbers.
double missed_by(const std::vector<ConePart>& parts, const Eigen::VectorXd& numbers) {
  double maximum = 0;
  Eigen::Index first = 0;
  for (const auto& [kind, size] : parts) {
    const Eigen::VectorXd part = numbers.segment(first, size);
    first += size;
    if (kind == ConePart::Kind::zero) maximum = std::max(maximum, part.cwiseAbs().maxCoeff());
    if (kind == ConePart::Kind::nonnegative) maximum = std::max(maximum, -part.minCoeff());
    if (kind == ConePart::Kind::second_order) {
      maximum = std::max(maximum, part.tail(size - 1).norm() - part(0));
    }
  }
  EXPECT_EQ(first, numbers.size());
  return maximum;
}

template <int D>
void expect_solution_within(std::mt19937_64& generator) {
  const auto problem = testing::random_problem(D, 5, 0.1, 2, generator);
  const auto [contact, separated] = testing::random_masks(5, generator);
  NodeSolver<D> solver(problem.compliance, problem.friction);
  const auto answer =
      solver.solve(contact, separated, {.when_infeasible = false, .when_feasible = false});
  Eigen::VectorXd point(5 * D + 1);
  point << solver.reaction(), answer.lower;
  const auto program = node_cone_program(problem.compliance, problem.friction, contact, separated);
  EXPECT_LE(missed_by(program.columns, point), 0);
  EXPECT_LE(missed_by(program.rows, program.matrix * point + program.constants), 1e-9);
  // A slightly larger t violates a cone or a gap: the solver's point has them active.
  point(5 * D) = answer.upper + 1e-6;
  EXPECT_GT(missed_by(program.rows, program.matrix * point + program.constants), 0);
  EXPECT_EQ(program.costs.dot(point), point(5 * D));
}

TEST(BenchmarkFormat, AdmitsTheSolutionOfTheSolver) {
  std::mt19937_64 generator(14);
  for (int time = 0; time < 30; ++time) {
    expect_solution_within<2>(generator);
    expect_solution_within<3>(generator);
  }
}

}  // namespace
}  // namespace kusabi::conic
