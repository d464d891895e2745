// A mixed 0-1 program: a knapsack of capacity 55, items of weights 10, 20, 30 and values 60, 100,
// 120, and the value 1 for each unit of unused capacity. Optimum 225: two items and 5 units.
#include <cstdio>

#include "engine/transport/single_process.hpp"
#include "nodes/zero_one/mixed_search.hpp"
#include "solvers/linear/linear_program.hpp"

using namespace kusabi;

int main() {
  linear::MixedProgram mixed;
  auto& program = mixed.program;  // minimised
  for (const double value : {60, 100, 120}) {
    mixed.binaries.push_back(static_cast<int>(program.columns.size()));
    program.columns.push_back({.cost = -value, .lower = 0, .upper = 1});
  }
  program.columns.push_back({.cost = -1, .lower = 0, .upper = 55});
  const linear::LinearTerm weights[] = {{0, 10}, {1, 20}, {2, 30}, {3, 1}};
  program.add_row({.upper = 55}, weights);

  engine::SingleProcess alone;
  engine::Analysis analysis(alone);
  const auto found = zero_one::solve_mixed(analysis, mixed);
  if (found.status() != zero_one::MixedStatus::optimal) return 1;
  std::printf("value %.6f, at most %.6f%s:", -found.point()->objective, -found.bound(),
              found.proved() ? ", proved" : "");
  for (const double value : found.point()->values) std::printf(" %.3f", value);
  std::printf("\n");
  return 0;
}
