// Directed rounding of sums and products without changing the rounding mode of the processor: the
// nearest double is corrected by the sign of its error, which is exact (Knuth's sum, a fused
// multiply-add).
#pragma once

#include <cmath>
#include <limits>

namespace kusabi::linear {

/// An enclosure [lower, upper] of a number.
struct Interval {
  double lower = 0;
  double upper = 0;
};

namespace rounded {

inline double before(double x) {
  return std::nextafter(x, -std::numeric_limits<double>::infinity());
}

/// Error a + b - fl(a + b) of a finite sum.
inline double sum_error(double a, double b, double sum) {
  const double shadow = sum - a;
  return (a - (sum - shadow)) + (b - shadow);
}

inline double sum_down(double a, double b) {
  const double sum = a + b;
  if (!std::isfinite(sum)) {
    // Overflow of finite summands: the lower result is the largest finite number.
    const bool overflow = std::isfinite(a) && std::isfinite(b);
    return overflow && sum > 0 ? std::numeric_limits<double>::max() : sum;
  }
  // An error that overflows, as it may next to the largest number, is not reliable.
  return sum_error(a, b, sum) >= 0 ? sum : before(sum);
}

inline double sum_up(double a, double b) {
  return -sum_down(-a, -b);
}

/// Zero times infinity is zero here: a multiplier of zero cancels any bound.
inline double product_down(double a, double b) {
  if (a == 0 || b == 0) return 0;
  const double product = a * b;
  if (!std::isfinite(product)) {
    // Overflow of finite factors: the lower result is the largest finite number.
    const bool overflow = std::isfinite(a) && std::isfinite(b);
    return overflow && product > 0 ? std::numeric_limits<double>::max() : product;
  }
  constexpr double error_may_underflow = 1e-290;
  if (std::abs(product) < error_may_underflow) return before(product);
  return std::fma(a, b, -product) < 0 ? before(product) : product;
}

inline double product_up(double a, double b) {
  return -product_down(-a, b);
}

}  // namespace rounded

inline Interval operator+(const Interval& a, const Interval& b) {
  return {rounded::sum_down(a.lower, b.lower), rounded::sum_up(a.upper, b.upper)};
}

inline Interval product(double a, double b) {
  return {rounded::product_down(a, b), rounded::product_up(a, b)};
}

}  // namespace kusabi::linear
