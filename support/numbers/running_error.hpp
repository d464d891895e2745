// How wrong a computation in 104 bits may be, found by doing it once more: Wilkinson's running
// error analysis. Code that is a template of its scalar is run in `Precise` for the numbers and in
// `RunningError` for their bounds, so there is nothing to be derived by hand, and nothing that
// becomes wrong when the code changes.
#pragma once

#include <cmath>
#include <limits>

#include "support/numbers/precise.hpp"

namespace kusabi::numbers {

/// A number x, known as `value`. What the same operations give in `Precise` is within `error` times
/// unit_roundoff<Precise> of x, and `value` within `error` times that of doubles: both kinds of
/// number keep the rules at `unit_roundoff`. The bounds themselves are rounded to nearest: a few
/// thousand operations make them less than a thousandth too small.
struct RunningError {
  double value = 0;
  double error = 0;

  RunningError() = default;
  RunningError(double exact) : value(exact) {}  // NOLINT(google-explicit-constructor): as Precise
  RunningError(double number, double bound) : value(number), error(bound) {}

  /// Not below |x|, its value in `Precise`, and |value|.
  [[nodiscard]] double most() const { return std::abs(value) + 0x1p-52 * error; }
  /// Not above these.
  [[nodiscard]] double least() const { return std::abs(value) - 0x1p-52 * error; }

  RunningError& operator+=(const RunningError& other);
  RunningError& operator-=(const RunningError& other);
  RunningError& operator*=(const RunningError& other);
};

inline RunningError operator+(const RunningError& a, const RunningError& b) {
  return {a.value + b.value, a.error + b.error + a.most() + b.most()};
}
inline RunningError operator-(const RunningError& a) {
  return {-a.value, a.error};
}
inline RunningError operator-(const RunningError& a, const RunningError& b) {
  return a + -b;
}
inline RunningError operator*(const RunningError& a, const RunningError& b) {
  const double x = a.most();
  const double y = b.most();
  return {a.value * b.value, x * b.error + y * a.error + x * y};
}
/// Of no bound where b may be zero.
inline RunningError operator/(const RunningError& a, const RunningError& b) {
  const double y = b.least();
  if (!(y > 0)) return {a.value / b.value, std::numeric_limits<double>::infinity()};
  return {a.value / b.value, (a.error + a.most() + a.most() * b.error / y) / y};
}
/// Of no bound where a may be zero.
inline RunningError sqrt(const RunningError& a) {
  const double x = a.least();
  if (!(x > 0)) return {std::sqrt(a.value), std::numeric_limits<double>::infinity()};
  return {std::sqrt(a.value), a.error / (2 * std::sqrt(x)) + std::sqrt(a.most())};
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

/// a - b of two doubles, which two doubles hold exactly.
template <class Real>
Real difference(double a, double b) {
  return Real(a) - Real(b);
}
/// One rounding, that of its own double.
template <>
inline RunningError difference<RunningError>(double a, double b) {
  return {a - b, std::abs(a - b)};
}

}  // namespace kusabi::numbers
