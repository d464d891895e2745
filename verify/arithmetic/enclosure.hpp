// Intervals that hold a number which is not a double: a length, a direction cosine, 1/sqrt(3). All
// operations round outwards (MPFR), so what they give holds every value that the exact operation
// has on the numbers of its arguments.
#pragma once

#include <mpfr.h>

#include "verify/arithmetic/exact.hpp"

namespace kusabi::verify {

/// [lower, upper], both of 320 binary digits. An operation without a result (a division by an
/// interval with zero in it, the root of a negative number) gives one that is not finite.
class Enclosure {
 public:
  /// @param value exactly @pre finite
  explicit Enclosure(double value = 0);
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

  /// Adds a * b, the sum alone rounded.
  void add_product(const Enclosure& a, const Enclosure& b);

  [[nodiscard]] bool finite() const;
  [[nodiscard]] bool is_zero() const;  ///< exactly [0, 0]

  /// The ends, exactly. @pre finite()
  [[nodiscard]] Dyadic lower() const;
  [[nodiscard]] Dyadic upper() const;

  /// A number that |x - value| does not exceed for any x within. @pre finite()
  [[nodiscard]] Dyadic distance(const Dyadic& value) const;

 private:
  mpfr_t lower_;
  mpfr_t upper_;
};

}  // namespace kusabi::verify
