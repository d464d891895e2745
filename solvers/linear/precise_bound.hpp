// Safe bound (safe_bound.hpp) of multipliers y with 104 bits. If costs differ by twelve decades, as
// penalties and prices do, the reduced costs c - A'y of the best y in doubles consist of rounding
// only, and the error of the bound would exceed the objective.
#pragma once

#include <span>
#include <vector>

#include "solvers/linear/linear_program.hpp"
#include "solvers/linear/safe_bound.hpp"
#include "support/numbers/precise.hpp"

namespace kusabi::linear {

/// Treatment of a reduced cost that should be zero but is not quite, for a column without the bound
/// that the cost presses on.
enum class Residuals {
  proved,    ///< the bound is minus infinity: it is rigorous
  forgiven,  ///< zero if within rounding, 2^-80 of its terms: accurate, but not a proof
};

/// As safe_bound() of doubles. Rounding errors of the 104 bits are bounded and subtracted.
SafeBound safe_bound(const LinearProgram& program, std::span<const numbers::Precise> duals,
                     std::span<const double> lower, std::span<const double> upper,
                     Residuals residuals = Residuals::proved);

/// As safe_infeasibility() of doubles: above zero if no point satisfies all rows and bounds.
double safe_infeasibility(const LinearProgram& program, std::span<const numbers::Precise> duals,
                          std::span<const double> lower, std::span<const double> upper,
                          Residuals residuals = Residuals::proved);

}  // namespace kusabi::linear
