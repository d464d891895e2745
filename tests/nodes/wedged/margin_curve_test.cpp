// Zeros of curves from values and slopes, on curves with known zeros.
#include "nodes/wedged/friction/margin_curve.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace kusabi::wedged {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Concave, as t* below its zero, which is at 0.6.
double margin(double factor) {
  return 1 / 0.6 - 1 / factor;
}
double tangent(double factor) {
  return factor - margin(factor) * factor * factor;
}

void add(MarginCurve& curve, double factor) {
  curve.add(factor, margin(factor), tangent(factor));
}

TEST(MarginCurve, FindsTheZeroFromBelowInAFewPoints) {
  MarginCurve curve(1e-8);
  add(curve, 0.5);
  double error = 0.1;
  for (int points = 1; points < 4; ++points) {
    const auto estimate = curve.next(0, infinity);
    const double now = std::abs(estimate.factor - 0.6);
    if (estimate.settled) {
      EXPECT_LT(now, 1e-8);
      return;
    }
    EXPECT_LT(now, error / 3);
    error = now;
    add(curve, estimate.factor);
  }
  ADD_FAILURE() << "four points do not settle it";
}

TEST(MarginCurve, UsesTheTangentFromAboveUntilAPointBelowIsKnown) {
  MarginCurve curve(1e-8);
  curve.add(0.8, 0.1, 0.7);
  const auto estimate = curve.next(0.5, 0.8);
  EXPECT_EQ(estimate.factor, 0.7);
  EXPECT_FALSE(estimate.settled);
  // The estimate stays within the open interval.
  EXPECT_GE(curve.next(0.75, 0.8).factor, 0.75);
  EXPECT_LT(curve.next(0.75, 0.8).factor, 0.8);
}

TEST(MarginCurve, EndsAfterAStepBelowTheRootOfTheWidth) {
  for (const double step : {1e-4, 1e-6}) {
    MarginCurve curve(1e-8);
    curve.add(0.6, step, 0.6 - step);
    EXPECT_EQ(curve.next(0.5, 0.6).settled, step < 1e-5) << step;
  }
}

TEST(MarginCurve, StepsDownFromADegeneratePoint) {
  MarginCurve curve(1e-8);
  curve.add(0.8, 0.1, 0.7);
  curve.add_degenerate(0.7);
  EXPECT_EQ(curve.min_degenerate(), 0.7);
  const auto estimate = curve.next(0.1, 0.7);
  EXPECT_LT(estimate.factor, 0.7);
  EXPECT_GE(estimate.factor, 0.1);
}

// For arbitrary points the estimate stays within the interval of the zero.
TEST(MarginCurve, StaysWithinTheIntervalOfTheZero) {
  MarginCurve curve(1e-8);
  for (const double newton : {-5.0, 0.2, 0.9, infinity, std::nan("")}) {
    for (const double margin : {-1.0, -1e-12, 0.0, 1.0}) {
      for (const double factor : {0.3, 0.5}) {
        curve.add(factor, margin, newton);
        const auto estimate = curve.next(0.4, 0.45);
        EXPECT_GE(estimate.factor, 0.4);
        EXPECT_LT(estimate.factor, 0.45);
      }
    }
  }
}

}  // namespace
}  // namespace kusabi::wedged
