// Exact arithmetic of dyadic numbers, mantissa * 2^exponent. Doubles are dyadic, and so are their
// sums and products. Only functions whose names say so round (sqrt_above, kept_bits).
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <gmpxx.h>

namespace kusabi::verify {

/// True if no number is infinite or NaN.
bool all_finite(std::span<const double> values);

/// An exact dyadic number.
class Dyadic {
 public:
  Dyadic() = default;
  /// @throws std::domain_error if it is infinite or not a number
  explicit Dyadic(double value);
  Dyadic(mpz_class mantissa, long exponent) : mantissa_(std::move(mantissa)), exponent_(exponent) {}

  [[nodiscard]] int sign() const { return sgn(mantissa_); }
  [[nodiscard]] double nearest() const;      ///< a double close to it, on either side
  [[nodiscard]] mpq_class rational() const;  ///< the same number

  /// The number times 2^exponent, exactly.
  [[nodiscard]] Dyadic scaled(long exponent) const { return {mantissa_, exponent_ + exponent}; }

  /// The largest integer n such that n * 2^exponent does not exceed the number.
  [[nodiscard]] mpz_class multiples(long exponent) const;

  /// Adds a * b, mostly without new memory.
  /// @throws std::domain_error if b is infinite or not a number
  void add_product(const Dyadic& a, double b);

  friend Dyadic operator+(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) {
    return a + Dyadic(-b.mantissa_, b.exponent_);
  }
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    return {a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_};
  }
  friend bool operator<(const Dyadic& a, const Dyadic& b) { return (a - b).sign() < 0; }
  friend bool operator>(const Dyadic& a, const Dyadic& b) { return b < a; }

  /// Upper bound of the square root of `value` with a relative error below 2^-60.
  /// @pre value >= 0
  friend Dyadic sqrt_above(const Dyadic& value);

  /// Upper bound of a / b with a relative error below 2^-60.
  /// @pre a >= 0, b > 0
  friend Dyadic quotient_above(const Dyadic& a, const Dyadic& b);

  /// Zero, or the exponent e for which 2^(e-1) <= |value| < 2^e.
  [[nodiscard]] long magnitude() const;

  /// Exponent such that the number is a multiple of 2^exponent().
  [[nodiscard]] long exponent() const { return exponent_; }

 private:
  mpz_class mantissa_ = 0;
  long exponent_ = 0;
};

/// x^2.
inline Dyadic square(const Dyadic& x) {
  return x * x;
}

/// |x|.
inline Dyadic absolute(const Dyadic& x) {
  return x.sign() < 0 ? Dyadic() - x : x;
}

/// The larger of the two.
inline const Dyadic& larger(const Dyadic& a, const Dyadic& b) {
  return a < b ? b : a;
}

/// The nearest doubles below and above the number or equal to it; infinite if there is none.
double rounded_down(const mpq_class& value);
double rounded_up(const mpq_class& value);

/// Numbers with a common exponent: entry i is mantissas[i] * 2^exponent.
struct DyadicList {
  std::vector<mpz_class> mantissas;
  long exponent = 0;

  DyadicList() = default;
  /// @param kept_bits digits further below the largest number than this are truncated; by default
  ///        none are
  /// @pre all finite
  explicit DyadicList(std::span<const double> values,
                      int kept_bits = std::numeric_limits<int>::max());

  /// The given numbers.
  explicit DyadicList(std::span<const Dyadic> values);

  /// `count` zeros.
  explicit DyadicList(std::size_t count) : mantissas(count) {}

  /// Adds or subtracts a list of the same size, entry by entry.
  DyadicList& operator+=(DyadicList other);
  DyadicList& operator-=(DyadicList other);

  [[nodiscard]] std::size_t size() const { return mantissas.size(); }
  [[nodiscard]] Dyadic operator[](std::size_t i) const { return {mantissas[i], exponent}; }
};

/// A square matrix, stored by rows.
struct DyadicMatrix {
  std::size_t size = 0;
  DyadicList entries;

  /// The matrix times a vector. @pre x.size() == size
  [[nodiscard]] DyadicList operator*(const DyadicList& x) const;
};

/// The set of all symmetric matrices whose distance from `middle` in the Frobenius norm is at most
/// `radius`.
struct EnclosedMatrix {
  DyadicMatrix middle;
  Dyadic radius;  ///< >= 0; zero: only the matrix itself
};

}  // namespace kusabi::verify
