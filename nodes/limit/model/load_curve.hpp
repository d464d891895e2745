// Load factor as a function of a load that grows in proportion (limit paper, remark 3.3 and Figure
// 5): concave and piecewise linear, each piece a collapse mode.
//
// A mode u of (15) is a feasible point of the dual for every load, so its line lies above the curve
// everywhere and on it where the mode is optimal. The parametric method solves at both ends, then
// at the intersection of the lines of neighbouring modes; either the curve passes there, which is a
// breakpoint, or the basis found there is a new mode between them. p pieces take at most 2 p + 1
// linear programs, and no breakpoint is missed or displaced (M. J. Eisner, D. G. Severance,
// Mathematical techniques for efficient record segmentation in large shared databases, J. ACM 23
// (1976) 619-635). The curve ends where the load has no factor.
#pragma once

#include <functional>
#include <optional>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "support/bracket.hpp"

namespace kusabi::limit {

/// The curve at one place, and the mode found there.
struct CurvePoint {
  double at = 0;
  double factor = 0;
  double slope = 0;  ///< of the mode's line
  Eigen::VectorXd motion;
};

/// A place where the load has no factor.
struct NotCarried {
  double last = 0;  ///< upper bound, exact or approximate, of the places with a factor, by a motion
                    ///< found there
  support::Standing standing{};  ///< of the claim that the place has no factor
};

/// Result at a place; nothing: unknown, since the simplex method failed or was stopped.
using CurveSample = std::variant<std::monostate, CurvePoint, NotCarried>;

/// A linear piece: from `from` to the `from` of the next one, or to the end of the curve. All
/// breakpoints have been solved.
struct CurvePiece {
  CurvePoint from;  ///< with the slope and motion of the piece
  double to = 0;
  double factor_at_end = 0;
  /// Bound of the distance from the curve on the whole piece, proved in exact arithmetic; nothing:
  /// not proved.
  std::optional<double> error{};
};

/// Bracket of the end of a curve.
struct CurveEnd {
  double carried_at = 0;
  double not_carried_at = 0;
  support::Standing standing{};  ///< of the claim that the latter has no factor
};

struct LoadCurve {
  std::vector<CurvePiece> pieces;  ///< in order, from 0 on; empty: some place is unknown
  std::optional<CurveEnd> end;     ///< nothing: the curve continues to the end of the range

  /// True if all of it is proved in exact arithmetic.
  [[nodiscard]] bool proved() const;
};

/// Relative width of the bracket of the end of a curve: the simplex method accepts forces with
/// equilibrium errors of 1e-9 of a yield force.
inline constexpr double default_end_width = 1e-7;

/// The curve from 0 to `end`, or to its own end.
/// @param sample the curve at a place, which is not called for the same place twice in succession
/// @param tolerance for equal factors
LoadCurve concave_curve(const std::function<CurveSample(double)>& sample, double end,
                        double tolerance, double end_width = default_end_width);

}  // namespace kusabi::limit
