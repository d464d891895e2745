// Answers of a linear program that have passed a check. A simplex method in floating point may call
// a program infeasible that is not, or a point optimal that satisfies no row: its tolerances are
// those of the program as it scales it. An object of these types can only be made by its check, in
// the numbers of the program as given; whatever rests on an answer takes one of them.
//
// The tolerance of each condition is `check_tolerance` times the magnitudes of its own terms, or
// times one if they are smaller: the program is to be scaled to the order of one. The check does
// not replace a proof (safe_bound.hpp, verify).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "solvers/linear/linear_program.hpp"

namespace kusabi::linear {

/// GLPK's tolerance of 1e-9 holds for the program as it scales it; ten times that allows for its
/// scale factors.
inline constexpr double check_tolerance = 1e-8;

/// A point and multipliers of the rows that satisfy the conditions of an optimum: rows and bounds
/// hold, reduced costs have the right sign, and a bound with a multiplier is active.
class CheckedOptimum {
 public:
  /// Nothing if a condition is violated.
  /// @param values of the columns
  /// @param duals of the rows, with the signs of Simplex::dual()
  static std::optional<CheckedOptimum> of(const LinearProgram& program, std::vector<double> values,
                                          std::vector<double> duals);

  [[nodiscard]] double objective() const { return objective_; }
  [[nodiscard]] double value(int column) const { return values_[static_cast<std::size_t>(column)]; }
  [[nodiscard]] double dual(int row) const { return duals_[static_cast<std::size_t>(row)]; }
  /// c - A'dual
  [[nodiscard]] double reduced_cost(int column) const {
    return reduced_[static_cast<std::size_t>(column)];
  }
  [[nodiscard]] std::span<const double> values() const { return values_; }
  [[nodiscard]] std::span<const double> duals() const { return duals_; }

 private:
  CheckedOptimum() = default;

  double objective_ = 0;
  std::vector<double> values_;
  std::vector<double> duals_;
  std::vector<double> reduced_;
};

/// Multipliers of the rows which show that no point satisfies all rows and bounds: the combination
/// y'A x of the rows exceeds its maximum over the bounds of the columns (Farkas).
class CheckedInfeasibility {
 public:
  /// Nothing if the multipliers do not show it, or only by less than rounding errors may explain.
  static std::optional<CheckedInfeasibility> of(const LinearProgram& program,
                                                std::vector<double> multipliers);

  /// Empty if the bounds of one row or column contradict each other.
  [[nodiscard]] std::span<const double> multipliers() const { return multipliers_; }

 private:
  CheckedInfeasibility() = default;

  std::vector<double> multipliers_;
};

}  // namespace kusabi::linear
