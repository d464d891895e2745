// Estimates of the end, with bisection where they are of no use.
#include "nodes/wedged/hold/end_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

namespace kusabi::wedged {
namespace {

/// More than bisection takes on both sides of undecided points, to all digits of a double.
constexpr int max_end_steps = 150;

/// Share of the required width by which points are chosen beside an estimate that is exact to all
/// digits: both are then closer to each other than the width.
constexpr double share_beside = 0.3;

/// In so many steps secants must make the bracket as much shorter as so many bisections less one;
/// otherwise as many bisections follow.
constexpr int steps_of_trust = 4;

/// Factor by which the distance from the estimate grows if a point was not on the expected side.
constexpr double growth_of_distance = 8;

bool is_between(double point, double one, double other) {
  return std::min(one, other) < point && point < std::max(one, other);
}

// Estimates of the end: the last point up to which states are excluded, or the zero of the secant of
// t*, preferably through the last two points without states. With states t* has kinks, and is flat
// (margin_curve.hpp).
class EndEstimate {
 public:
  // The next point: at about the error of the estimate beside it, towards the farther one of both
  // points of the end, which then is as close. Nothing: bisection is to be preferred.
  std::optional<double> next(const PatternEnd& end, double width) {
    const double zero = estimate();
    const double error = std::abs(zero - estimate_);
    estimate_ = zero;
    if (!is_trusted(std::abs(end.feasible - end.infeasible))) return {};
    if (!is_between(zero, end.feasible, end.infeasible)) return {};
    expects_states_ = std::abs(end.feasible - zero) > std::abs(end.infeasible - zero);
    const double far = expects_states_ ? end.feasible : end.infeasible;
    const double beside =
        std::max({std::isfinite(error) ? error : 0, share_beside * width, beside_});
    const double point = zero + std::copysign(beside, far - zero);
    return is_between(point, end.feasible, end.infeasible) ? point : std::midpoint(zero, far);
  }

  // @param expected true: the point is that of next()
  void add(double point, const PointAnswer& answer, bool expected, double width) {
    const bool has_states = answer.result == HoldResult::feasible;
    if (expected) {
      const bool missed = has_states != expects_states_;
      beside_ = missed ? growth_of_distance * std::max(beside_, share_beside * width) : 0;
    }
    if (std::isfinite(answer.excluded_to)) excluded_to_ = answer.excluded_to;
    if (!std::isfinite(answer.margin)) return;
    auto& points = has_states ? with_states_ : without_;
    points = {points[1], {point, answer.margin}};
  }

 private:
  struct Point {
    double point = std::numeric_limits<double>::quiet_NaN();
    double margin = 0;
  };
  using Points = std::array<Point, 2>;  // the last one and that before

  // Not a number if nothing is known.
  [[nodiscard]] double estimate() const {
    if (std::isfinite(excluded_to_)) return excluded_to_;
    const auto is_known = [](const Point& each) { return !std::isnan(each.point); };
    const Point& one = is_known(without_[1]) ? without_[1] : with_states_[1];
    const Point& other = is_known(without_[0])   ? without_[0]
                         : is_known(without_[1]) ? with_states_[1]
                                                 : with_states_[0];
    return one.point - one.margin * (one.point - other.point) / (one.margin - other.margin);
  }

  // @param length of the bracket
  bool is_trusted(double length) {
    const int turn = steps_++ % steps_of_trust;
    if (turn == 0) {
      trusted_ = !trusted_ || length <= std::exp2(1 - steps_of_trust) * length_;
      length_ = length;
    }
    return trusted_;
  }

  Points without_, with_states_;
  double excluded_to_ = std::numeric_limits<double>::quiet_NaN();
  double estimate_ = std::numeric_limits<double>::quiet_NaN();
  double beside_ = 0;  // least distance of the next point from the estimate
  bool expects_states_ = false;
  int steps_ = 0;
  bool trusted_ = false;
  double length_ = 0;
};

}  // namespace

PatternEnd close_in(PatternEnd end, EndWidth width,
                    const std::function<PointAnswer(double)>& answer_at,
                    const std::function<bool()>& stopped) {
  auto& [feasible, infeasible, undecided] = end;
  // The nearest undecided points on both sides.
  double open_feasible = infeasible, open_infeasible = feasible;
  const auto width_at = [&](double one, double other) {
    return std::max(width.relative * std::max(std::abs(one), std::abs(other)), width.absolute);
  };
  const auto close = [&](double one, double other) {
    return std::abs(one - other) <= width_at(one, other);
  };
  EndEstimate estimates;
  for (int step = 0; step < max_end_steps; ++step) {
    if (close(feasible, infeasible) ||
        (undecided && close(feasible, open_feasible) && close(open_infeasible, infeasible)))
      return end;
    if (stopped()) {
      undecided = true;
      return end;
    }
    const bool beyond = undecided && step % 2 != 0;  // both sides of undecided points in turn
    const double from = beyond ? open_infeasible : feasible;
    const double to = undecided && !beyond ? open_feasible : infeasible;
    const double bound = width_at(feasible, infeasible);
    const auto estimate = undecided ? std::nullopt : estimates.next(end, bound);
    const double point = estimate.value_or(from + (to - from) / 2);
    if (point == from || point == to) {
      if (!undecided) return end;
      continue;
    }
    const PointAnswer answer = answer_at(point);
    estimates.add(point, answer, estimate.has_value(), bound);
    switch (answer.result) {
      case HoldResult::feasible:
        feasible = point;
        break;
      case HoldResult::infeasible:
        infeasible = point;
        break;
      default:
        if (!undecided) open_feasible = open_infeasible = point;
        (beyond ? open_infeasible : open_feasible) = point;
        undecided = true;
    }
  }
  return end;
}

}  // namespace kusabi::wedged
