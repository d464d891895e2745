// Four numbers in a SIMD register, added in a fixed order: sums do not depend on compiler
// optimisations and need no -ffast-math.
#pragma once

#include "support/simd.hpp"

namespace kusabi::limit::splitting {

struct alignas(32) Lanes {
  using Four = double __attribute__((vector_size(32)));

  Lanes() = default;
  KUSABI_INLINE Lanes(const Four& four) : values(four) {}
  KUSABI_INLINE Lanes(double one) : values(Four{} + one) {}

  KUSABI_INLINE double& operator[](int lane) {
    return reinterpret_cast<double*>(&values)[lane];  // NOLINT: GCC and Clang permit this alias
  }
  KUSABI_INLINE double operator[](int lane) const { return values[lane]; }
  KUSABI_INLINE Lanes operator-() const { return -values; }
  KUSABI_INLINE Lanes& operator+=(const Lanes& other) { return *this = values + other.values; }
  KUSABI_INLINE Lanes& operator-=(const Lanes& other) { return *this = values - other.values; }
  KUSABI_INLINE friend Lanes operator+(const Lanes& a, const Lanes& b) {
    return a.values + b.values;
  }
  KUSABI_INLINE friend Lanes operator-(const Lanes& a, const Lanes& b) {
    return a.values - b.values;
  }
  KUSABI_INLINE friend Lanes operator*(const Lanes& a, const Lanes& b) {
    return a.values * b.values;
  }

  Four values;
};

/// |x|
KUSABI_INLINE Lanes size_of(const Lanes& x) {
  return x.values < 0 ? -x.values : x.values;
}

/// max(x, 0)
KUSABI_INLINE Lanes positive(const Lanes& x) {
  return x.values > 0 ? x.values : Lanes::Four{};
}

/// One where x > 0, otherwise zero.
KUSABI_INLINE Lanes is_positive(const Lanes& x) {
  return x.values > 0 ? Lanes::Four{} + 1.0 : Lanes::Four{};
}

/// x where the other number is positive, elsewhere y.
KUSABI_INLINE Lanes where_positive(const Lanes& other, const Lanes& x, const Lanes& y) {
  return other.values > 0 ? x.values : y.values;
}

/// x between bounds.
KUSABI_INLINE Lanes clamped(const Lanes& x, const Lanes& lower, const Lanes& upper) {
  const Lanes::Four below = x.values < upper.values ? x.values : upper.values;
  return below > lower.values ? below : lower.values;
}

KUSABI_INLINE double sum_of(const Lanes& x) {
  return (x[0] + x[1]) + (x[2] + x[3]);
}

}  // namespace kusabi::limit::splitting
