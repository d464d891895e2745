// The end of the points on a line at which one sign pattern has states: of load factors, friction
// coefficients, sums of normal reactions. The states of a pattern are convex, so that there is one
// end in each direction, and t* of its cone program changes sign there.
//
// Bisection to nine digits takes 33 programs, the last of which are solved in higher precision. The
// points up to which the multipliers of an infeasible point exclude states approach the end
// quadratically, and are exact where the same inequalities remain active; secants of t* serve where
// they are not known. Both take about ten programs, two of them in higher precision.
#pragma once

#include <functional>
#include <limits>

#include "nodes/wedged/hold/hold_tree.hpp"

namespace kusabi::wedged {

/// What the program of a pattern says at one point.
struct PointAnswer {
  HoldResult result;
  double margin = std::numeric_limits<double>::quiet_NaN();  ///< t*, if known
  /// Of an infeasible point: another one up to which its multipliers exclude states, if known.
  double excluded_to = std::numeric_limits<double>::quiet_NaN();
};

/// An end: the pattern has states at `feasible`, and none at `infeasible`.
struct PatternEnd {
  double feasible, infeasible;
  bool undecided = false;  ///< points between them are undecided, or the search was stopped
};

/// How close both points of an end are to be.
struct EndWidth {
  double relative;  ///< to the larger of both
  double absolute;  ///< where the end is zero
};

/// Moves both points towards each other until they are close.
/// @param answer_at results other than `feasible` and `infeasible` are undecided points; both sides
///        of them are then searched
/// @param stopped true: the search ends
PatternEnd close_in(PatternEnd end, EndWidth width,
                    const std::function<PointAnswer(double)>& answer_at,
                    const std::function<bool()>& stopped);

}  // namespace kusabi::wedged
