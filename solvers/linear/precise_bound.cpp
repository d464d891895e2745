// Safe bound by sums of 104 bits with their error bounds.
#include "solvers/linear/precise_bound.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "solvers/linear/rounded.hpp"

namespace kusabi::linear {
namespace {

using numbers::Precise;

constexpr double roundoff = numbers::unit_roundoff<Precise>;
constexpr double forgiven_share = 0x1p-80;
// Factor for the rounding of error sums, which are doubles rounded to nearest.
constexpr double at_most = 1 + 1e-6;

// A sum, and the sum of the magnitudes of its terms.
class Sum {
 public:
  void add(const Precise& term) {
    value_ += term;
    size_ += std::abs(term.x[0]);
    ++terms_;
  }
  // Adds a term with an error of at most `error`.
  void add(const Precise& term, double error) {
    add(term);
    error_ += error;
  }
  [[nodiscard]] const Precise& value() const { return value_; }
  [[nodiscard]] double size() const { return size_ * at_most; }
  // Bound of the rounding error: each term is at most one product, and each addition has an error
  // relative to its summands.
  [[nodiscard]] double error() const {
    return (roundoff * (2 * static_cast<double>(terms_) + 4) * size_ + error_) * at_most;
  }

 private:
  Precise value_ = 0.0;
  double size_ = 0;
  double error_ = 0;
  std::size_t terms_ = 0;
};

// Adds the minimum of r x over [lower, upper], with |r - residual| <= error; false if it is
// unbounded.
bool add_minimum(Sum& total, const Sum& residual, double lower, double upper, Residuals residuals) {
  const Precise& r = residual.value();
  const double error = residual.error();
  const bool above = r >= Precise(error);
  const bool below = r <= Precise(-error);
  const auto product = [&](double bound) { return r * Precise(bound); };
  if (r.x[0] == 0 && error == 0) return true;
  if (above || below) {
    const double bound = above ? lower : upper;
    if (std::isfinite(bound)) {
      if (bound != 0) total.add(product(bound), error * std::abs(bound));
      return true;
    }
  } else if (std::isfinite(lower) && std::isfinite(upper)) {
    const auto minimum = std::min(product(lower), product(upper));
    total.add(minimum, error * std::max(std::abs(lower), std::abs(upper)));
    return true;
  }
  return residuals == Residuals::forgiven && std::abs(r.x[0]) <= forgiven_share * residual.size();
}

SafeBound bound(const LinearProgram& program, std::span<const Precise> duals,
                std::span<const double> lower, std::span<const double> upper, Residuals residuals,
                bool with_costs) {
  std::vector<Precise> y(duals.begin(), duals.end());
  Sum total;
  if (with_costs) total.add(program.constant);
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double pressed = y[i].x[0] > 0 ? program.rows[i].lower : program.rows[i].upper;
    if (!std::isfinite(pressed) || !std::isfinite(y[i].x[0])) y[i] = 0.0;
    if (y[i].x[0] != 0 && pressed != 0) total.add(y[i] * Precise(pressed));
  }
  std::vector<Sum> sums(program.columns.size());
  if (with_costs) {
    for (std::size_t j = 0; j < sums.size(); ++j) sums[j].add(program.columns[j].cost);
  }
  for (const auto& [row, column, value] : program.entries) {
    const auto& multiplier = y[static_cast<std::size_t>(row)];
    if (multiplier.x[0] != 0) {
      sums[static_cast<std::size_t>(column)].add(multiplier * Precise(-value));
    }
  }
  SafeBound result;
  bool finite = true;
  for (std::size_t j = 0; j < sums.size(); ++j) {
    const double middle = sums[j].value().x[0];
    const double error = sums[j].error();
    // The second double of the pair is smaller than the distance to the neighbours of the first.
    result.residuals.push_back({rounded::sum_down(rounded::before(middle), -error),
                                rounded::sum_up(-rounded::before(-middle), error)});
    if (!add_minimum(total, sums[j], lower[j], upper[j], residuals)) finite = false;
  }
  const double value = rounded::sum_down(rounded::before(total.value().x[0]), -total.error());
  if (finite && !std::isnan(value)) result.value = value;
  return result;
}

}  // namespace

SafeBound safe_bound(const LinearProgram& program, std::span<const Precise> duals,
                     std::span<const double> lower, std::span<const double> upper,
                     Residuals residuals) {
  return bound(program, duals, lower, upper, residuals, true);
}

double safe_infeasibility(const LinearProgram& program, std::span<const Precise> duals,
                          std::span<const double> lower, std::span<const double> upper,
                          Residuals residuals) {
  return bound(program, duals, lower, upper, residuals, false).value;
}

}  // namespace kusabi::linear
