// How the load factor falls as a load grows in proportion (limit paper, remark 3.3 and Figure 5):
// a concave, piecewise linear function whose pieces are the collapse modes.
//
// A mode u of (15) is a feasible point of the dual for every load, so its line lies above the curve
// everywhere and on it where the mode is optimal. The parametric method follows from that: solve at
// both ends, then where the lines of two neighbouring modes meet; either the curve is there, and
// that is a breakpoint, or the basis found there is a new mode between them. With p pieces it takes
// 2 p + 1 linear programs at most, and no breakpoint can be missed or be off by a step (M. J.
// Eisner, D. G. Severance, Mathematical techniques for efficient record segmentation in large
// shared databases, J. ACM 23 (1976) 619-635).
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace kusabi::limit {

/// The curve at one place, and the mode found there.
struct CurvePoint {
  double at = 0;
  double factor = 0;
  double slope = 0;  ///< of the mode's line
  Eigen::VectorXd motion;
};

/// A linear piece: from `from` to the `from` of the next one, or to the end.
struct CurvePiece {
  CurvePoint from;  ///< its slope and motion are those of the piece
  double to = 0;
  double factor_at_end = 0;
};

/// The pieces between 0 and `end`, in order.
/// @param solve the curve and a mode at a place; nothing: the load there is not carried at any
///        factor, and the curve is not given
/// @param tolerance what factors may differ by without being different
std::vector<CurvePiece> concave_curve(const std::function<std::optional<CurvePoint>(double)>& solve,
                                      double end, double tolerance);

}  // namespace kusabi::limit
