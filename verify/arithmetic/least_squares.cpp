// Gram-Schmidt orthogonalisation of the columns, repeated once. Normal equations would square the
// condition number, which for rotations about a distant point is the ratio of the lever to the size
// of the body. Rigid-body modes of many bodies are zero at the candidates of the others.
#include "verify/arithmetic/least_squares.hpp"

#include <cmath>
#include <numeric>
#include <utility>

namespace kusabi::verify {

double LeastSquares::Unit::take_out(std::vector<double>& from) const {
  double part = 0;
  for (std::size_t row = first; row < end; ++row) part += values[row] * from[row];
  if (part == 0) return 0;
  for (std::size_t row = first; row < end; ++row) from[row] -= part * values[row];
  return part;
}

LeastSquares::LeastSquares(std::span<const double> matrix, std::size_t rows) {
  const auto columns = rows == 0 ? 0 : matrix.size() / rows;
  independent_ = columns <= rows;
  if (!independent_) return;
  parts_.assign(columns, std::vector<double>(columns, 0));
  for (std::size_t i = 0; i < columns; ++i) {
    std::vector<double> column;
    for (std::size_t row = 0; row < rows; ++row) column.push_back(matrix[columns * row + i]);
    for (int time = 0; time < 2; ++time) {
      for (std::size_t j = 0; j < i; ++j) parts_[i][j] += units_[j].take_out(column);
    }
    const double size =
        std::sqrt(std::inner_product(column.begin(), column.end(), column.begin(), 0.0));
    independent_ = size > 0 && std::isfinite(size);
    if (!independent_) return;
    for (double& each : column) each /= size;
    parts_[i][i] = size;
    Unit unit{std::move(column), 0, rows};
    while (unit.values[unit.first] == 0) ++unit.first;
    while (unit.values[unit.end - 1] == 0) --unit.end;
    units_.push_back(std::move(unit));
  }
}

std::optional<std::vector<double>> LeastSquares::solve(std::span<const double> right) const {
  if (!independent_ || (!units_.empty() && right.size() != units_.front().values.size())) return {};
  const auto columns = units_.size();
  std::vector<double> rest(right.begin(), right.end());
  std::vector<double> solution;
  solution.reserve(columns);
  for (const auto& unit : units_) solution.push_back(unit.take_out(rest));
  for (std::size_t i = columns; i-- > 0;) {
    for (std::size_t j = i + 1; j < columns; ++j) solution[i] -= parts_[j][i] * solution[j];
    solution[i] /= parts_[i][i];
  }
  return solution;
}

}  // namespace kusabi::verify
