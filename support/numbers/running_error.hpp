// RunningError: Wilkinson's running error analysis of a computation in 104 bits. Code templated on
// its scalar is run in `Precise` for the values and in `RunningError` for their error bounds, so
// that no bound is derived by hand.
#pragma once

#include <cmath>
#include <limits>

#include "support/numbers/precise.hpp"

namespace kusabi::numbers {

/// A number x with error bounds. The same operations in `Precise` give a result within `error`
/// times unit_roundoff<Precise> of x, and `value` is within `error` times unit_roundoff<double>.
/// The bounds themselves are rounded to nearest: a few thousand operations make them too small by
/// less than a thousandth.
struct RunningError {
  double value = 0;
  double error = 0;

  RunningError() = default;
  RunningError(double exact) : value(exact) {}  // NOLINT(google-explicit-constructor): as Precise
  RunningError(double number, double bound) : value(number), error(bound) {}

  /// Upper bound of |x|, of its value in `Precise`, and of |value|.
  [[nodiscard]] double maximum() const { return std::abs(value) + 0x1p-52 * error; }
  /// Lower bound of the same.
  [[nodiscard]] double minimum() const { return std::abs(value) - 0x1p-52 * error; }

  RunningError& operator+=(const RunningError& other);
  RunningError& operator-=(const RunningError& other);
  RunningError& operator*=(const RunningError& other);
};

inline RunningError operator+(const RunningError& a, const RunningError& b) {
  return {a.value + b.value, a.error + b.error + a.maximum() + b.maximum()};
}
inline RunningError operator-(const RunningError& a) {
  return {-a.value, a.error};
}
inline RunningError operator-(const RunningError& a, const RunningError& b) {
  return a + -b;
}
inline RunningError operator*(const RunningError& a, const RunningError& b) {
  const double x = a.maximum();
  const double y = b.maximum();
  return {a.value * b.value, x * b.error + y * a.error + x * y};
}
/// Infinite error if b may be zero.
inline RunningError operator/(const RunningError& a, const RunningError& b) {
  const double y = b.minimum();
  if (!(y > 0)) return {a.value / b.value, std::numeric_limits<double>::infinity()};
  return {a.value / b.value, (a.error + a.maximum() + a.maximum() * b.error / y) / y};
}
/// Infinite error if a may be zero.
inline RunningError sqrt(const RunningError& a) {
  const double x = a.minimum();
  if (!(x > 0)) return {std::sqrt(a.value), std::numeric_limits<double>::infinity()};
  return {std::sqrt(a.value), a.error / (2 * std::sqrt(x)) + std::sqrt(a.maximum())};
}
inline RunningError abs(const RunningError& a) {
  return {std::abs(a.value), a.error};
}

inline RunningError& RunningError::operator+=(const RunningError& other) {
  return *this = *this + other;
}
inline RunningError& RunningError::operator-=(const RunningError& other) {
  return *this = *this - other;
}
inline RunningError& RunningError::operator*=(const RunningError& other) {
  return *this = *this * other;
}

/// a - b of two doubles; exact if Real is a sum of two doubles.
template <class Real>
Real difference(double a, double b) {
  return Real(a) - Real(b);
}
/// With the error of one rounding.
template <>
inline RunningError difference<RunningError>(double a, double b) {
  return {a - b, std::abs(a - b)};
}

}  // namespace kusabi::numbers
