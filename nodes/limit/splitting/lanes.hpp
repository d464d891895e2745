// Pairs of numbers in SIMD registers, added in a fixed order: sums do not depend on compiler
// optimisations and need no -ffast-math.
#pragma once

namespace kusabi::limit::splitting {

using Lanes = double __attribute__((vector_size(16)));

inline Lanes all(double value) {
  return Lanes{} + value;
}

/// |x|
inline Lanes size_of(const Lanes& x) {
  return x < 0 ? -x : x;
}

/// max(x, 0)
inline Lanes positive(const Lanes& x) {
  return x > 0 ? x : Lanes{};
}

/// One where x > 0, otherwise zero.
inline Lanes is_positive(const Lanes& x) {
  return x > 0 ? Lanes{} + 1.0 : Lanes{};
}

/// x between bounds.
inline Lanes clamped(const Lanes& x, const Lanes& lower, const Lanes& upper) {
  const Lanes below = x < upper ? x : upper;
  return below > lower ? below : lower;
}

inline double sum_of(const Lanes& x) {
  return x[0] + x[1];
}

}  // namespace kusabi::limit::splitting
