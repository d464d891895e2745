// Safe bound of a linear program in interval arithmetic.
#include "solvers/linear/safe_bound.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "solvers/linear/rounded.hpp"

namespace kusabi::linear {
namespace {

SafeBound bound(const LinearProgram& program, std::span<const double> duals,
                std::span<const double> lower, std::span<const double> upper, bool with_costs) {
  std::vector<double> y(duals.begin(), duals.end());
  double total = with_costs ? program.constant : 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double pressed = y[i] > 0 ? program.rows[i].lower : program.rows[i].upper;
    if (!std::isfinite(pressed) || !std::isfinite(y[i])) y[i] = 0;
    if (y[i] != 0) total = rounded::sum_down(total, rounded::product_down(y[i], pressed));
  }
  std::vector<Interval> residual(program.columns.size());
  if (with_costs) {
    for (std::size_t j = 0; j < residual.size(); ++j) {
      residual[j] = {program.columns[j].cost, program.columns[j].cost};
    }
  }
  for (const auto& [row, column, value] : program.entries) {
    const double multiplier = y[static_cast<std::size_t>(row)];
    auto& r = residual[static_cast<std::size_t>(column)];
    if (multiplier != 0) r = r + product(-value, multiplier);
  }
  bool finite = true;
  for (std::size_t j = 0; j < residual.size(); ++j) {
    const double minimum = min_product(residual[j], lower[j], upper[j]);
    if (std::isfinite(minimum)) {
      total = rounded::sum_down(total, minimum);
    } else {
      finite = finite && minimum > 0;
    }
  }
  if (std::isnan(total)) total = -infinity;
  return {finite ? total : -infinity, total, std::move(residual)};
}

}  // namespace

double min_product(const Interval& residual, double lower, double upper) {
  using rounded::product_down;
  return std::min({product_down(residual.lower, lower), product_down(residual.lower, upper),
                   product_down(residual.upper, lower), product_down(residual.upper, upper)});
}

double max_contribution(const Interval& residual, double lower, double upper) {
  const auto least = [&](double cost) {
    return std::min(rounded::product_up(cost, lower), rounded::product_up(cost, upper));
  };
  // The minimum is concave in r, and zero at zero.
  const double ends = std::max(least(residual.lower), least(residual.upper));
  return residual.lower < 0 && residual.upper > 0 ? std::max(ends, 0.0) : ends;
}

SafeBound safe_bound(const LinearProgram& program, std::span<const double> duals,
                     std::span<const double> lower, std::span<const double> upper) {
  return bound(program, duals, lower, upper, true);
}

double safe_dual_bound(const LinearProgram& program, std::span<const double> duals) {
  std::vector<double> lower;
  std::vector<double> upper;
  lower.reserve(program.columns.size());
  upper.reserve(program.columns.size());
  for (const auto& column : program.columns) {
    lower.push_back(column.lower);
    upper.push_back(column.upper);
  }
  return safe_dual_bound(program, duals, lower, upper);
}

double safe_dual_bound(const LinearProgram& program, std::span<const double> duals,
                       std::span<const double> lower, std::span<const double> upper) {
  return bound(program, duals, lower, upper, true).value;
}

double safe_infeasibility(const LinearProgram& program, std::span<const double> duals,
                          std::span<const double> lower, std::span<const double> upper) {
  return bound(program, duals, lower, upper, false).value;
}

}  // namespace kusabi::linear
