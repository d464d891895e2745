// What is asked of the solvers of node programs and what they answer, whatever numbers they compute
// with.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace kusabi::conic {

/// What is proved about t*: positive, negative, or neither.
enum class Sign { alive, dead, marginal };

/// All in the scaled units of the compliance (mean diagonal of its normal block 1).
struct Tolerances {
  double sign = 1e-12;  ///< |t*| up to this is a tie; 1e-12 to 1e-3 is sensible
  double value = 1e-8;  ///< width of the bracket, relative to max(1, |t*|), that ends the iteration
  int iterations = 60;  ///< ordinary nodes need 10 to 20
  /// Above this |t*| is told by its sign even where it counts as a tie by `sign`: the structure is
  /// meant as its numbers stand.
  double resolution = std::numeric_limits<double>::infinity();

  /// |t*| above this is told by its sign.
  [[nodiscard]] double least_told() const { return std::min(sign, resolution); }
};

/// Whether to stop once the sign is proved; otherwise the iteration goes on to the full accuracy
/// of the value. A tie stops early in any case.
struct StopEarly {
  bool when_dead = true;
  bool when_alive = true;
  /// Or once t* is proved to be at least this, or at most that, or to lie in so narrow a bracket.
  double above = std::numeric_limits<double>::infinity();
  double below = -std::numeric_limits<double>::infinity();
  double width = -1;
};

/// The bracket lower <= t* <= upper and what is concluded from it. Both ends hold in spite of
/// rounding and of the error of F that was stated.
struct Answer {
  /// alive: lower > tolerance; dead: upper < -tolerance, the resolution if it is less. Marginal is
  /// the rest: a tie if the bracket lies within [-tolerance, tolerance], undecided if it does not.
  Sign sign = Sign::marginal;
  double lower = 0;            ///< minus infinity where nothing is proved
  double upper = 0;            ///< proved by multipliers(); minus infinity when R is everything
  int iterations = 0;          ///< factorisations, of all rungs
  double primal_residual = 0;  ///< largest |u_n| / sqrt(F_nn) on U at reaction(), as computed
  double gap = 0;              ///< upper - lower
  bool has_point = false;      ///< reaction() proves `lower`
  int rung = 0;                ///< numbers it took: 0 double, 1 long double, 2 of 104 bits
};

/// What is known of the sign.
inline Sign sign_of(const Answer& answer, const Tolerances& tolerances) {
  const double least = tolerances.least_told();
  if (answer.upper < -least) return Sign::dead;
  return answer.lower > least ? Sign::alive : Sign::marginal;
}

/// Whether the bracket of a marginal answer lies within the tolerance.
inline bool is_tie(const Answer& answer, const Tolerances& tolerances) {
  return answer.upper <= tolerances.sign && answer.lower >= -tolerances.sign;
}

/// Whether the bracket is so narrow about zero that no sign is told.
inline bool is_resolved_tie(const Answer& answer, const Tolerances& tolerances) {
  const double least = tolerances.least_told();
  return answer.upper <= least && answer.lower >= -least;
}

/// Width of a bracket, relative to its ends, below which the value has three digits to spare.
constexpr double sharp = 1e-4;

/// Whether no further iteration is wanted.
inline bool is_settled(const Answer& answer, StopEarly stop, const Tolerances& tolerances) {
  // A bound this low only says that u_n = 0 on U has no solution: t* is minus infinity, and further
  // iterations would push the bound down for ever.
  constexpr double bottom = -1e9;
  if (answer.upper < bottom || is_resolved_tie(answer, tolerances)) return true;
  if (answer.lower >= stop.above || answer.upper <= stop.below ||
      answer.upper - answer.lower <= stop.width)
    return true;
  const Sign sign = sign_of(answer, tolerances);
  if (sign == Sign::marginal) return false;
  if (sign == Sign::dead ? stop.when_dead : stop.when_alive) return true;
  const double size = std::max(std::abs(answer.upper), std::abs(answer.lower));
  if (!std::isfinite(size)) return false;
  return answer.upper - answer.lower <=
         std::min(tolerances.value * std::max(1.0, size), sharp * size);
}

}  // namespace kusabi::conic
