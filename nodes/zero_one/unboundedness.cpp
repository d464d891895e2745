// Linear program of the directions within a box.
#include "nodes/zero_one/unboundedness.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "solvers/linear/precise_simplex.hpp"

namespace kusabi::zero_one {

bool decreases_without_bound(const linear::MixedProgram& mixed, const support::Stop& stop) {
  const auto end = [](double bound, double otherwise) {
    return std::isfinite(bound) ? 0 : otherwise;
  };
  linear::LinearProgram directions;
  double largest = 0;
  for (const auto& column : mixed.program.columns) {
    directions.add_column(
        {.cost = column.cost, .lower = end(column.lower, -1), .upper = end(column.upper, 1)});
    largest = std::max(largest, std::abs(column.cost));
  }
  for (const int column : mixed.binaries) {
    auto& held = directions.columns[static_cast<std::size_t>(column)];
    held.lower = held.upper = 0;
  }
  for (const auto& row : mixed.program.rows) {
    directions.rows.push_back(
        {.lower = end(row.lower, -linear::infinity), .upper = end(row.upper, linear::infinity)});
  }
  directions.entries = mixed.program.entries;
  const auto found = linear::solve_precisely(directions, {}, stop);
  // Smaller numbers may be rounding errors.
  constexpr double rounding = 1e-18;
  return found.status == linear::LinearStatus::optimal &&
         numbers::rounded(found.objective) < -rounding * largest;
}

}  // namespace kusabi::zero_one
