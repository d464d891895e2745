// Intersections of lines, solved and divided recursively.
#include "nodes/limit/model/load_curve.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kusabi::limit {
namespace {

using Sample = std::function<CurveSample(double)>;

/// Breakpoints closer than this share of the range are equal.
constexpr double same_place = 1e-9;

/// A load without factor above this share of the range has a factor at zero only. The share is
/// small, since the requested range may be far too wide.
constexpr double no_place = 1e-18;

double line(const CurvePoint& point, double at) {
  return point.factor + point.slope * (at - point.at);
}

// The last place with a factor, by bisection and by the places that motions indicate.
std::optional<std::pair<CurvePoint, CurveEnd>> last_carried(const Sample& sample, CurvePoint first,
                                                            double end, NotCarried beyond,
                                                            double end_width) {
  CurveEnd bracket{first.at, end, beyond.standing};
  for (;;) {
    const double width = std::max(end_width * bracket.not_carried_at, no_place * end);
    if (bracket.not_carried_at - bracket.carried_at <= width) break;
    const auto inside = [&](double at) {
      return bracket.carried_at < at && at < bracket.not_carried_at;
    };
    double at = (bracket.carried_at + bracket.not_carried_at) / 2;
    if (inside(beyond.last + width / 3)) at = beyond.last + width / 3;
    if (inside(beyond.last - width / 3)) at = beyond.last - width / 3;
    auto found = sample(at);
    if (auto* const point = std::get_if<CurvePoint>(&found)) {
      first = std::move(*point);
      bracket.carried_at = at;
    } else if (const auto* const none = std::get_if<NotCarried>(&found)) {
      beyond = *none;
      bracket.not_carried_at = at;
      bracket.standing = none->standing;
    } else {
      return {};
    }
  }
  return std::pair(std::move(first), bracket);
}

class Parametric {
 public:
  Parametric(const Sample& sample, double end, double tolerance)
      : sample_(sample), near_(same_place * end), tolerance_(tolerance) {}

  /// The modes from left to right, each with the end of its piece. @return false: unknown
  bool between(const CurvePoint& left, const CurvePoint& right);

  /// Ends the last piece.
  void finish(const CurvePoint& last) { add(last, last.at); }

  std::vector<CurvePiece> pieces;

 private:
  void add(const CurvePoint& mode, double to);

  const Sample& sample_;
  double near_;
  double tolerance_;
};

bool Parametric::between(const CurvePoint& left, const CurvePoint& right) {
  const double turn = left.slope - right.slope;
  if (turn <= 0 || std::abs(line(left, right.at) - right.factor) <= tolerance_) {
    add(left, right.at);
    return true;
  }
  const double meet = (line(right, 0) - line(left, 0)) / turn;
  if (meet - left.at < near_) {
    add(left, left.at);
    return true;
  }
  if (right.at - meet < near_) {
    add(left, right.at);
    return true;
  }
  const auto found = sample_(meet);
  const auto* const middle = std::get_if<CurvePoint>(&found);
  if (middle == nullptr) return false;
  if (middle->factor >= line(left, meet) - tolerance_) {
    add(left, meet);
    return true;
  }
  return between(left, *middle) && between(*middle, right);
}

// A mode whose line continues the previous one is the same mode, found twice.
void Parametric::add(const CurvePoint& mode, double to) {
  const double from = pieces.empty() ? 0 : pieces.back().to;
  if (to - from < near_) return;
  if (!pieces.empty()) {
    auto& last = pieces.back();
    const bool one_line =
        std::abs(line(last.from, to) - line(mode, to)) <= tolerance_ &&
        std::abs(line(last.from, last.from.at) - line(mode, last.from.at)) <= tolerance_;
    if (one_line) {
      last.to = to;
      last.factor_at_end = line(last.from, to);
      return;
    }
  }
  CurvePoint start = mode;
  start.at = from;
  start.factor = line(mode, from);
  pieces.push_back({std::move(start), to, line(mode, to)});
}

}  // namespace

bool LoadCurve::proved() const {
  const auto is_shown = [](const CurvePiece& piece) { return piece.error.has_value(); };
  return !pieces.empty() && std::ranges::all_of(pieces, is_shown) &&
         (!end || is_proved(end->standing));
}

LoadCurve concave_curve(const Sample& sample, double end, double tolerance, double end_width) {
  const auto at_zero = sample(0);
  const auto* const first = std::get_if<CurvePoint>(&at_zero);
  if (first == nullptr) return {};
  LoadCurve curve;
  auto at_end = sample(end);
  if (const auto* const none = std::get_if<NotCarried>(&at_end)) {
    auto found = last_carried(sample, *first, end, *none, end_width);
    if (!found) return {};
    curve.end = found->second;
    at_end = std::move(found->first);
  }
  const auto* const last = std::get_if<CurvePoint>(&at_end);
  if (last == nullptr) return {};
  if (last->at == 0) {  // the smallest load has no factor
    curve.pieces.push_back({*first, 0, first->factor});
    return curve;
  }
  Parametric parametric(sample, last->at, tolerance);
  if (!parametric.between(*first, *last)) return {};
  parametric.finish(*last);
  curve.pieces = std::move(parametric.pieces);
  return curve;
}

}  // namespace kusabi::limit
