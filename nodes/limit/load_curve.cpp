// Meeting points of lines, solved and split.
#include "nodes/limit/load_curve.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kusabi::limit {
namespace {

using Solve = std::function<std::optional<CurvePoint>(double)>;

/// Breakpoints nearer to each other than this share of the range are one.
constexpr double same_place = 1e-9;

double line(const CurvePoint& point, double at) {
  return point.factor + point.slope * (at - point.at);
}

// The modes between two, and the two themselves, from left to right.
bool modes_between(const Solve& solve, const CurvePoint& left, const CurvePoint& right, double end,
                   double tolerance, std::vector<CurvePoint>& modes) {
  const bool one_line = std::abs(line(left, right.at) - right.factor) <= tolerance;
  const double turn = left.slope - right.slope;
  if (one_line || turn <= 0) return true;
  const double meet = (line(right, 0) - line(left, 0)) / turn;
  if (meet - left.at < same_place * end || right.at - meet < same_place * end) return true;
  const auto between = solve(meet);
  if (!between) return false;
  if (between->factor >= line(left, meet) - tolerance) return true;
  if (!modes_between(solve, left, *between, end, tolerance, modes)) return false;
  modes.push_back(*between);
  return modes_between(solve, *between, right, end, tolerance, modes);
}

}  // namespace

std::vector<CurvePiece> concave_curve(const Solve& solve, double end, double tolerance) {
  const auto first = solve(0);
  const auto last = solve(end);
  if (!first || !last) return {};
  std::vector<CurvePoint> modes{*first};
  if (!modes_between(solve, *first, *last, end, tolerance, modes)) return {};
  modes.push_back(*last);
  std::vector<CurvePiece> pieces;
  double at = 0;
  for (std::size_t k = 0; k < modes.size(); ++k) {
    double to = end;
    if (k + 1 < modes.size()) {
      const double turn = modes[k].slope - modes[k + 1].slope;
      // One line from both ends, or a corner at an end: nothing is between.
      if (turn <= 0 ||
          std::abs(line(modes[k], modes[k + 1].at) - modes[k + 1].factor) <= tolerance) {
        to = modes[k + 1].at;
        const bool same = std::abs(line(modes[k + 1], at) - line(modes[k], at)) <= tolerance;
        if (same) continue;  // the next one starts here
      } else {
        to = std::clamp((line(modes[k + 1], 0) - line(modes[k], 0)) / turn, at, end);
      }
    }
    if (to - at < same_place * end) continue;
    CurvePoint from = modes[k];
    from.factor = line(modes[k], at);
    from.at = at;
    pieces.push_back({std::move(from), to, line(modes[k], to)});
    at = to;
  }
  return pieces;
}

}  // namespace kusabi::limit
