// Gram-Schmidt orthogonalisation of the columns, repeated once. Normal equations would square the
// condition number, which for rotations about a distant point is the ratio of the lever to the size
// of the body.
#include "verify/arithmetic/least_squares.hpp"

#include <cmath>
#include <numeric>
#include <utility>

namespace kusabi::verify {
namespace {

using Numbers = std::vector<double>;

double product(const Numbers& a, const Numbers& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

// Subtracts the component along a unit vector from a column. @return that component
double take_out(const Numbers& unit, Numbers& from) {
  const double part = product(unit, from);
  for (std::size_t row = 0; row < unit.size(); ++row) from[row] -= part * unit[row];
  return part;
}

}  // namespace

std::optional<std::vector<double>> least_squares(std::span<const double> matrix,
                                                 std::span<const double> right) {
  if (right.empty() || matrix.empty()) return std::vector<double>{};
  const auto columns = matrix.size() / right.size();
  std::vector<Numbers> units;
  std::vector<Numbers> parts(
      columns, Numbers(columns, 0));  // parts[i][j]: component of column i along unit vector j
  for (std::size_t i = 0; i < columns; ++i) {
    Numbers column;
    for (std::size_t row = 0; row < right.size(); ++row)
      column.push_back(matrix[columns * row + i]);
    for (int time = 0; time < 2; ++time) {
      for (std::size_t j = 0; j < i; ++j) parts[i][j] += take_out(units[j], column);
    }
    const double size = std::sqrt(product(column, column));
    if (!(size > 0)) return {};
    for (double& each : column) each /= size;
    parts[i][i] = size;
    units.push_back(std::move(column));
  }
  Numbers rest(right.begin(), right.end());
  std::vector<double> solution;
  solution.reserve(columns);
  for (const auto& unit : units) solution.push_back(take_out(unit, rest));
  for (std::size_t i = columns; i-- > 0;) {
    for (std::size_t j = i + 1; j < columns; ++j) solution[i] -= parts[j][i] * solution[j];
    solution[i] /= parts[i][i];
  }
  return solution;
}

}  // namespace kusabi::verify
