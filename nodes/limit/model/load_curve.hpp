// How the load factor falls as a load grows in proportion (limit paper, remark 3.3 and Figure 5):
// a concave, piecewise linear function whose pieces are the collapse modes.
//
// A mode u of (15) is a feasible point of the dual for every load, so its line lies above the curve
// everywhere and on it where the mode is optimal. The parametric method follows from that: solve at
// both ends, then where the lines of two neighbouring modes meet; either the curve is there, and
// that is a breakpoint, or the basis found there is a new mode between them. With p pieces it takes
// 2 p + 1 linear programs at most, and no breakpoint can be missed or be off by a step (M. J.
// Eisner, D. G. Severance, Mathematical techniques for efficient record segmentation in large
// shared databases, J. ACM 23 (1976) 619-635). Where the load is no longer carried the curve ends.
#pragma once

#include <functional>
#include <optional>
#include <variant>
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

/// A place where the load is carried at no factor.
struct NotCarried {
  double last = 0;  ///< by a motion found there it is carried no farther than here, or hereabouts
  bool proved = false;  ///< whether exact arithmetic shows it of the place itself
};

/// What a place comes to; nothing: not known, because the simplex method failed or was to end.
using CurveSample = std::variant<std::monostate, CurvePoint, NotCarried>;

/// A linear piece: from `from` to the `from` of the next one, or to the end. All places where it
/// begins and ends have been solved at.
struct CurvePiece {
  CurvePoint from;  ///< its slope and motion are those of the piece
  double to = 0;
  double factor_at_end = 0;
  /// What exact arithmetic shows the curve to be within on all of the piece; nothing: not shown.
  std::optional<double> error{};
};

/// Between which two places a curve ends.
struct CurveEnd {
  double carried_at = 0;
  double not_carried_at = 0;
  bool proved = false;  ///< whether exact arithmetic shows the latter
};

struct LoadCurve {
  std::vector<CurvePiece> pieces;  ///< in order, from 0 on; empty: some place is not known
  std::optional<CurveEnd> end;     ///< nothing: it does not end before it was asked to

  /// Whether all of it is shown by exact arithmetic.
  [[nodiscard]] bool proved() const;
};

/// How narrowly the end of a curve is known, as a share of where it is: the simplex method takes
/// forces for equilibrium that are off by 1e-9 of a yield force.
inline constexpr double usual_end_width = 1e-7;

/// The curve from 0 to `end`, or to where it ends.
/// @param sample the curve at a place. It is not asked for one place twice in succession
/// @param tolerance what factors may differ by without being different
LoadCurve concave_curve(const std::function<CurveSample(double)>& sample, double end,
                        double tolerance, double end_width = usual_end_width);

}  // namespace kusabi::limit
