// Interval arithmetic for numbers that are not doubles, such as lengths, direction cosines and
// 1/sqrt(3). All operations round outwards (MPFR): the result contains all values of the exact
// operation on numbers within the arguments.
#pragma once

#include <mpfr.h>

#include "verify/arithmetic/exact.hpp"

namespace kusabi::verify {

/// The interval [lower, upper] of two numbers with 320 binary digits. An undefined operation
/// (division by an interval that contains zero, square root of a negative number) returns an
/// interval that is not finite.
class Enclosure {
 public:
  /// @param value represented exactly @pre finite
  explicit Enclosure(double value = 0);
  /// @param value rounded outwards
  explicit Enclosure(const Dyadic& value);
  Enclosure(const Enclosure& other);
  Enclosure(Enclosure&& other) noexcept;
  Enclosure& operator=(const Enclosure& other);
  Enclosure& operator=(Enclosure&& other) noexcept;
  ~Enclosure();

  friend Enclosure operator+(const Enclosure& a, const Enclosure& b);
  friend Enclosure operator-(const Enclosure& a, const Enclosure& b);
  friend Enclosure operator*(const Enclosure& a, const Enclosure& b);
  friend Enclosure operator/(const Enclosure& a, const Enclosure& b);
  friend Enclosure operator-(const Enclosure& a);
  friend Enclosure sqrt(const Enclosure& a);
  friend Enclosure magnitude(const Enclosure& a);  ///< the absolute value

  Enclosure& operator+=(const Enclosure& other) { return *this = *this + other; }
  Enclosure& operator-=(const Enclosure& other) { return *this = *this - other; }

  /// Adds a * b, where only the sum is rounded.
  void add_product(const Enclosure& a, const Enclosure& b);

  [[nodiscard]] bool finite() const;
  [[nodiscard]] bool is_zero() const;  ///< exactly [0, 0]

  /// The exact lower and upper bound. @pre finite()
  [[nodiscard]] Dyadic lower() const;
  [[nodiscard]] Dyadic upper() const;

  /// Upper bound of |x - value| for all x in the interval. @pre finite()
  [[nodiscard]] Dyadic distance(const Dyadic& value) const;

 private:
  mpfr_t lower_;
  mpfr_t upper_;
};

}  // namespace kusabi::verify
