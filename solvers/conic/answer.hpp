// Options and result of the solvers of node programs, for all scalar types.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace kusabi::conic {

/// Proved sign of t*: feasible (positive), infeasible (negative), or unproved.
enum class Sign { feasible, infeasible, unproved };

/// Tolerances, in the scaled units of the compliance (mean diagonal of its normal block 1).
struct Tolerances {
  double sign = 1e-12;  ///< |t*| up to this is degenerate; 1e-12 to 1e-3 is sensible
  /// width of the bracket, relative to max(1, |t*|), at which the iteration ends
  double value = 1e-8;
  int iterations = 60;  ///< ordinary nodes need 10 to 20
  /// Above this |t*| is classified by its sign even where it is degenerate by `sign`: the numbers
  /// of the file are then taken as exact.
  double resolution = std::numeric_limits<double>::infinity();

  /// |t*| above this is classified by its sign.
  [[nodiscard]] double min_resolved() const { return std::min(sign, resolution); }
};

/// Early stop as soon as the sign is proved; otherwise the iteration continues to the full accuracy
/// of the value. A degenerate node stops early in any case.
struct StopEarly {
  bool when_infeasible = true;
  bool when_feasible = true;
  /// Early stop, in addition, once t* >= above or t* <= below is proved, or the bracket is narrow
  /// enough.
  double above = std::numeric_limits<double>::infinity();
  double below = -std::numeric_limits<double>::infinity();
  double width = -1;
};

/// Bracket lower <= t* <= upper and its conclusion. Both bounds include rounding errors and the
/// stated error of F.
struct ConicResult {
  /// feasible: lower > tolerance; infeasible: upper < -tolerance, or the resolution if it is less;
  /// otherwise unproved: degenerate if the bracket lies within [-tolerance, tolerance], numerically
  /// undecided if it does not.
  Sign sign = Sign::unproved;
  double lower = 0;    ///< minus infinity if nothing is proved
  double upper = 0;    ///< proved by multipliers(); minus infinity if R contains all candidates
  int iterations = 0;  ///< number of factorisations, at all precision levels
  double primal_residual = 0;  ///< largest |u_n| / sqrt(F_nn) on U at reaction(), as computed
  double gap = 0;              ///< upper - lower
  bool has_point = false;      ///< true if reaction() proves `lower`
  int precision_level = 0;     ///< precision level used: 0 double, 1 long double, 2 104 bits
};

/// Sign proved by the bracket.
inline Sign sign_of(const ConicResult& answer, const Tolerances& tolerances) {
  const double minimum = tolerances.min_resolved();
  if (answer.upper < -minimum) return Sign::infeasible;
  return answer.lower > minimum ? Sign::feasible : Sign::unproved;
}

/// True if the bracket of a result with an unproved sign lies within the tolerance.
inline bool is_within_tolerance(const ConicResult& answer, const Tolerances& tolerances) {
  return answer.upper <= tolerances.sign && answer.lower >= -tolerances.sign;
}

/// True if the bracket is so narrow about zero that its sign is not resolved.
inline bool is_unresolvable(const ConicResult& answer, const Tolerances& tolerances) {
  const double minimum = tolerances.min_resolved();
  return answer.upper <= minimum && answer.lower >= -minimum;
}

/// Relative width of a bracket at which the value is settled: three digits are certain, with one in
/// reserve.
constexpr double known_digits_width = 1e-4;

/// True if no further iteration is needed.
inline bool is_settled(const ConicResult& answer, StopEarly stop, const Tolerances& tolerances) {
  // A bound this low means that u_n = 0 on U has no solution: t* is minus infinity, and further
  // iterations would lower the bound without end.
  constexpr double bottom = -1e9;
  if (answer.upper < bottom || is_unresolvable(answer, tolerances)) return true;
  if (answer.lower >= stop.above || answer.upper <= stop.below ||
      answer.upper - answer.lower <= stop.width)
    return true;
  const Sign sign = sign_of(answer, tolerances);
  if (sign == Sign::unproved) return false;
  if (sign == Sign::infeasible ? stop.when_infeasible : stop.when_feasible) return true;
  const double size = std::max(std::abs(answer.upper), std::abs(answer.lower));
  if (!std::isfinite(size)) return false;
  return answer.upper - answer.lower <=
         std::min(tolerances.value * std::max(1.0, size), known_digits_width * size);
}

}  // namespace kusabi::conic
