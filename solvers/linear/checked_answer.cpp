// Conditions row by row and column by column.
#include "solvers/linear/checked_answer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kusabi::linear {
namespace {

/// Share of the terms of a combination of rows below which it is zero: a multiplier has errors of
/// about 1e-13. Such a coefficient stands for zero if its column has no bound on that side.
constexpr double rounding = 1e-11;

// A sum, and the sum of the magnitudes of its terms.
struct Sum {
  double value = 0;
  double size = 0;

  void add(double term) {
    value += term;
    size += std::abs(term);
  }
  // True if the sum is zero within the tolerance. A NaN is not.
  [[nodiscard]] bool is_zero() const {
    return std::abs(value) <= check_tolerance * std::max(1.0, size);
  }
};

// True if `value` is not below `bound`, or not above it, within the tolerance. False for NaN.
bool is_above(const Sum& value, double bound) {
  return value.value >= bound - check_tolerance * std::max({1.0, value.size, std::abs(bound)});
}
bool is_below(const Sum& value, double bound) {
  return value.value <= bound + check_tolerance * std::max({1.0, value.size, std::abs(bound)});
}

bool is_within(const Sum& value, double lower, double upper) {
  return (lower == -infinity || is_above(value, lower)) &&
         (upper == infinity || is_below(value, upper));
}

// True if a multiplier is zero or belongs to an active bound.
bool is_complementary(const Sum& multiplier, const Sum& value, double lower, double upper) {
  if (multiplier.is_zero()) return true;
  if (multiplier.value > 0) return lower != -infinity && is_below(value, lower);
  return upper != infinity && is_above(value, upper);
}

std::vector<Sum> activities(const LinearProgram& program, std::span<const double> values) {
  std::vector<Sum> sums(program.rows.size());
  for (const auto& [row, column, value] : program.entries) {
    sums[static_cast<std::size_t>(row)].add(value * values[static_cast<std::size_t>(column)]);
  }
  return sums;
}

// c - A'y, or -A'y without costs.
std::vector<Sum> reduced_costs(const LinearProgram& program, std::span<const double> duals,
                               bool with_costs) {
  std::vector<Sum> sums(program.columns.size());
  if (with_costs) {
    for (std::size_t j = 0; j < sums.size(); ++j) sums[j].add(program.columns[j].cost);
  }
  for (const auto& [row, column, value] : program.entries) {
    sums[static_cast<std::size_t>(column)].add(-value * duals[static_cast<std::size_t>(row)]);
  }
  return sums;
}

bool contradicts_itself(const LinearProgram& program) {
  const auto empty = [](const auto& each) { return each.lower > each.upper; };
  return std::ranges::any_of(program.rows, empty) || std::ranges::any_of(program.columns, empty);
}

}  // namespace

std::optional<CheckedOptimum> CheckedOptimum::of(const LinearProgram& program,
                                                 std::vector<double> values,
                                                 std::vector<double> duals) {
  if (values.size() != program.columns.size() || duals.size() != program.rows.size()) return {};
  const auto rows = activities(program, values);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& [lower, upper, name] = program.rows[i];
    Sum dual;
    dual.add(duals[i]);
    if (!is_within(rows[i], lower, upper)) return {};
    if (!is_complementary(dual, rows[i], lower, upper)) return {};
  }
  CheckedOptimum optimum;
  optimum.objective_ = program.constant;
  const auto reduced = reduced_costs(program, duals, true);
  for (std::size_t j = 0; j < reduced.size(); ++j) {
    const auto& [cost, lower, upper, name] = program.columns[j];
    Sum value;
    value.add(values[j]);
    if (!is_within(value, lower, upper)) return {};
    if (!is_complementary(reduced[j], value, lower, upper)) return {};
    optimum.objective_ += cost * values[j];
    optimum.reduced_.push_back(reduced[j].value);
  }
  optimum.values_ = std::move(values);
  optimum.duals_ = std::move(duals);
  return optimum;
}

std::optional<CheckedInfeasibility> CheckedInfeasibility::of(const LinearProgram& program,
                                                             std::vector<double> multipliers) {
  CheckedInfeasibility shown;
  if (contradicts_itself(program)) return shown;
  if (multipliers.size() != program.rows.size()) return {};
  // Multipliers may have any size: the largest becomes one.
  double largest = 0;
  for (const double each : multipliers) largest = std::max(largest, std::abs(each));
  if (!(largest > 0) || !std::isfinite(largest)) return {};
  for (double& each : multipliers) each /= largest;
  Sum excess;
  for (std::size_t i = 0; i < multipliers.size(); ++i) {
    double& y = multipliers[i];
    const double pressed = y > 0 ? program.rows[i].lower : program.rows[i].upper;
    if (std::isfinite(pressed)) {
      excess.add(y * pressed);
    } else if (std::abs(y) > check_tolerance) {
      return {};
    } else {
      y = 0;
    }
  }
  const auto coefficients = reduced_costs(program, multipliers, false);
  for (std::size_t j = 0; j < coefficients.size(); ++j) {
    const auto& [value, size] = coefficients[j];
    const double bound = value > 0 ? program.columns[j].lower : program.columns[j].upper;
    if (std::isfinite(bound)) {
      excess.add(value * bound);
    } else if (!(std::abs(value) <= rounding * size)) {
      return {};
    }
  }
  if (!(excess.value > rounding * excess.size)) return {};
  shown.multipliers_ = std::move(multipliers);
  return shown;
}

}  // namespace kusabi::linear
