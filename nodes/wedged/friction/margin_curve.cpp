// Tangents from above, and from below cubic interpolation of two points.
#include "nodes/wedged/friction/margin_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace kusabi::wedged {
namespace {

// A tangent from below overestimates the zero by less than this share of the interval. A second
// point below, at this share before it, gives the curvature.
constexpr double bend = 0.2;

double squared(double number) {
  return number * number;
}

// Factor for the next point below a degenerate point, or where a tangent is of no use, as long as
// no infeasible point is known.
constexpr double downwards = 0.98;

// Accuracy of a step: the error of a tangent is a few times the square of the step, that of
// two points a few times the square of the product of both distances.
bool is_within(double step, double width) {
  return squared(10 * step) < width;
}

}  // namespace

void MarginCurve::add(double factor, double margin, double newton) {
  if (!std::isfinite(newton) || newton == factor) return;
  const Point point{factor, margin, newton};
  if (margin >= 0) {
    above_ = point;
  } else if (!below_ || factor > below_->factor) {
    further_below_ = below_;
    below_ = point;
  } else if (!further_below_ || factor > further_below_->factor) {
    further_below_ = point;
  }
}

void MarginCurve::add_degenerate(double factor) {
  min_degenerate_ = std::min(min_degenerate_, factor);
  above_.reset();
}

// The zero of the cubic through both points with their slopes, for the coefficient as a function of
// t*.
double MarginCurve::zero_between(const Point& one, const Point& other) {
  const double span = other.margin - one.margin;
  const double at = -one.margin / span;
  const double square = at * at;
  const double cube = square * at;
  return (2 * cube - 3 * square + 1) * one.factor + (cube - 2 * square + at) * span / one.slope() +
         (3 * square - 2 * cube) * other.factor + (cube - square) * span / other.slope();
}

MarginCurve::Estimate MarginCurve::from_below(const Point& point, double floor) const {
  const double step = point.newton - point.factor;
  if (is_within(step, width_)) return {point.newton, true};
  if (further_below_ && further_below_->margin != point.margin) {
    const double zero = zero_between(point, *further_below_);
    if (zero > point.factor && std::abs(zero - point.newton) < step / 2) {
      const double both = (zero - point.factor) * (zero - further_below_->factor);
      return {zero, is_within(2 * both, width_)};
    }
  }
  const double known = std::max(floor, point.factor);
  return {point.newton - bend * std::max(0.0, point.newton - known), false};
}

MarginCurve::Estimate MarginCurve::next(double floor, double top) const {
  const auto inside = [&](double factor) { return factor >= floor && factor < top; };
  const bool leads = above_ && inside(above_->newton);
  if (leads && is_within(above_->newton - above_->factor, width_)) return {above_->newton, true};
  if (below_) {
    const auto estimate = from_below(*below_, floor);
    if (inside(estimate.factor)) return estimate;
    const double known = std::max(floor, std::min(below_->factor, downwards * top));
    return {std::isfinite(top) ? std::midpoint(known, top) : 2 * known, false};
  }
  if (leads) return {above_->newton, false};
  return {std::isfinite(top) ? std::max(floor, downwards * top) : 2 * floor, false};
}

}  // namespace kusabi::wedged
