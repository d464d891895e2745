// The safe bound (safe_bound.hpp) of multipliers y with 104 bits. Where costs differ by twelve
// decades, as a penalty does from a price, the reduced costs c - A'y of the best y in doubles are
// nothing but rounding, and the bound would be wrong by more than the objective may be.
#pragma once

#include <span>
#include <vector>

#include "solvers/linear/linear_program.hpp"
#include "solvers/linear/safe_bound.hpp"
#include "support/numbers/precise.hpp"

namespace kusabi::linear {

/// How a reduced cost counts that should be zero but is not quite, of a column without the bound
/// on the side where its cost presses.
enum class Residuals {
  proved,    ///< the bound is minus infinity then: it holds in spite of rounding
  forgiven,  ///< zero if it is rounding, a part of 2^-80 of its terms: no proof, but all digits
};

/// As safe_bound() of doubles. Errors of the 104 bits are bounded and taken off.
SafeBound safe_bound(const LinearProgram& program, std::span<const numbers::Precise> duals,
                     std::span<const double> lower, std::span<const double> upper,
                     Residuals residuals = Residuals::proved);

/// As safe_infeasibility() of doubles: above zero if no point satisfies all rows and bounds.
double safe_infeasibility(const LinearProgram& program, std::span<const numbers::Precise> duals,
                          std::span<const double> lower, std::span<const double> upper,
                          Residuals residuals = Residuals::proved);

}  // namespace kusabi::linear
