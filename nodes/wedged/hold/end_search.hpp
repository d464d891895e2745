// The end of the points on a line at which one sign pattern has states: of load factors, friction
// coefficients, sums of normal reactions. The states of a pattern are convex, so that there is one
// end in each direction, and t* of its cone program changes sign there.
//
// Bisection to nine digits took 33 programs, the last of which are solved in higher precision. The
// zero of the secant of t* takes about ten, two of them in higher precision.
#pragma once

#include <functional>
#include <limits>

#include "nodes/wedged/hold/hold_tree.hpp"

namespace kusabi::wedged {

/// What the program of a pattern says at one point.
struct PointAnswer {
  HoldResult result;
  double margin = std::numeric_limits<double>::quiet_NaN();  ///< t*, if known
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
