// Columns and rows in the order of the functions that make the programs.
#include "problems/limit/program_names.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

#include <fmt/format.h>

namespace kusabi::problems {
namespace {

std::string degree_name(const LimitProblem& problem, int degree) {
  const auto& [node, axis] = problem.degrees.free[static_cast<std::size_t>(degree)];
  return fmt::format("{}.{}", problem.node_names[static_cast<std::size_t>(node)], axis_name(axis));
}

// Name of a column of T: its own, or that of the displacement of its component.
std::string uncertain_name(const LimitProblem& problem, std::size_t column) {
  const auto& given = problem.uncertain[column];
  if (given.name.empty()) return degree_name(problem, given.direction.front().degree);
  std::string name = given.name;
  std::ranges::replace(name, ' ', '_');
  return name;
}

}  // namespace

void name_static_program(const LimitProblem& problem, linear::LinearProgram& program) {
  auto column = program.columns.begin();
  for (int i = 0; i < problem.member_count(); ++i) {
    (column++)->name = "q." + member_name(problem, i);
  }
  column->name = "lambda";
  auto row = program.rows.begin();
  for (int k = 0; k < problem.free_count(); ++k) {
    (row++)->name = "equilibrium." + degree_name(problem, k);
  }
}

void name_kinematic_program(const LimitProblem& problem, linear::LinearProgram& program) {
  auto column = program.columns.begin();
  for (int k = 0; k < problem.free_count(); ++k) {
    (column++)->name = "u." + degree_name(problem, k);
  }
  auto row = program.rows.begin();
  (row++)->name = "reference";
  for (int i = 0; i < problem.member_count(); ++i) {
    const auto member = member_name(problem, i);
    (column++)->name = "z." + member;
    (row++)->name = "stretch." + member;
    (row++)->name = "shorten." + member;
  }
}

void name_worst_case_program(const LimitProblem& problem, linear::LinearProgram& program) {
  name_kinematic_program(problem, program);
  const std::size_t m = problem.uncertain.size();
  if (m == 0) return;
  auto* const gamma = &program.columns[static_cast<std::size_t>(problem.free_count()) +
                                       static_cast<std::size_t>(problem.member_count())];
  auto* const row = &program.rows[1 + 2 * problem.members.size()];
  for (std::size_t j = 0; j < m; ++j) {
    const auto name = uncertain_name(problem, j);
    gamma[j].name = "gamma." + name;
    gamma[m + j].name = "tau." + name;
    row[2 * j].name = "positive." + name;
    row[2 * j + 1].name = "negative." + name;
  }
}

}  // namespace kusabi::problems
