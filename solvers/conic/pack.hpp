// Pack: four doubles in one SIMD register, and the same operations on a single number of another
// type. Cones and matrix rows of a node program are processed in packs; a node program is so small
// that operations in registers dominate its time.
//
// Each lane rounds as a single double does, and sums have a fixed order on every machine: an
// operation is one instruction with AVX2, two otherwise. Multiplications and additions are never
// fused, so the results are bitwise equal everywhere.
#pragma once

#include <cmath>
#include <cstring>
#include <type_traits>

#include "support/numbers/precise.hpp"
#include "support/simd.hpp"

namespace kusabi::conic {

/// Numbers in a pack: four doubles, or one number of another type.
template <class Real = double>
inline constexpr int lanes = 1;
template <>
inline constexpr int lanes<double> = 4;

/// The smallest number of whole packs with room for `size` numbers, in numbers.
template <class Real = double>
constexpr int padded(int size) {
  return (size + lanes<Real> - 1) / lanes<Real> * lanes<Real>;
}

/// Four numbers; a single number converts to four equal ones.
struct alignas(32) Pack {
  using Lanes = double __attribute__((vector_size(32)));

  Pack() = default;
  KUSABI_INLINE Pack(const Lanes& four) : values(four) {}
  KUSABI_INLINE Pack(double one) : values(Lanes{1, 1, 1, 1} * one) {}

  KUSABI_INLINE double operator[](int lane) const { return values[lane]; }
  KUSABI_INLINE Pack operator-() const { return -values; }
  KUSABI_INLINE Pack& operator+=(const Pack& other) { return *this = values + other.values; }
  KUSABI_INLINE Pack& operator-=(const Pack& other) { return *this = values - other.values; }
  KUSABI_INLINE Pack& operator*=(const Pack& other) { return *this = values * other.values; }
  KUSABI_INLINE friend Pack operator+(const Pack& a, const Pack& b) { return a.values + b.values; }
  KUSABI_INLINE friend Pack operator-(const Pack& a, const Pack& b) { return a.values - b.values; }
  KUSABI_INLINE friend Pack operator*(const Pack& a, const Pack& b) { return a.values * b.values; }
  KUSABI_INLINE friend Pack operator/(const Pack& a, const Pack& b) { return a.values / b.values; }

  Lanes values;
};

/// A pack of numbers of this type.
template <class Real>
using Packed = std::conditional_t<std::is_same_v<Real, double>, Pack, Real>;

/// A type of which a single number is a pack.
template <class Real>
concept Alone = lanes<Real>
== 1 && !std::is_same_v<Real, Pack>;

/// Result of a comparison of two packs: in each lane all bits set for true, none for false.
struct alignas(32) Answers {
  KUSABI_INLINE Answers& operator&=(const Answers& others) {
    bits &= others.bits;
    return *this;
  }

  decltype(Pack::Lanes{} > Pack::Lanes{}) bits;
};

KUSABI_INLINE Answers operator>(const Pack& a, const Pack& b) {
  return {a.values > b.values};
}

KUSABI_INLINE Pack load(const double* from) {
  Pack pack;
  std::memcpy(&pack.values, from, sizeof pack.values);
  return pack;
}

KUSABI_INLINE void store(double* to, const Pack& pack) {
  std::memcpy(to, &pack.values, sizeof pack.values);
}

template <Alone Real>
KUSABI_INLINE const Real& load(const Real* from) {
  return *from;
}

template <Alone Real>
KUSABI_INLINE void store(Real* to, const Real& number) {
  *to = number;
}

/// A pack of numbers that are in registers, as load() would wait for them to be stored.
KUSABI_INLINE Pack pack_of(const double* numbers) {
  return Pack::Lanes{numbers[0], numbers[1], numbers[2], numbers[3]};
}

template <Alone Real>
KUSABI_INLINE Real pack_of(const Real* numbers) {
  return *numbers;
}

/// Stores two numbers, and zeros up to a whole pack.
KUSABI_INLINE void store_two(double* to, double first, double second) {
  store(to, Pack::Lanes{first, second, 0, 0});
}

template <Alone Real>
KUSABI_INLINE void store_two(Real* to, const Real& first, const Real& second) {
  to[0] = first;
  to[1] = second;
}

/// The number in a lane.
KUSABI_INLINE double in_lane(const Pack& pack, int lane) {
  return pack[lane];
}

template <Alone Real>
KUSABI_INLINE Real in_lane(const Real& number, int /*lane*/) {
  return number;
}

KUSABI_INLINE double root(double value) {
  return std::sqrt(value);
}

KUSABI_INLINE long double root(long double value) {
  return std::sqrt(value);
}

/// NaN for a negative number, as for the other types; QD itself would write to standard error.
inline numbers::Precise root(const numbers::Precise& value) {
  return value.is_negative() ? numbers::Precise(dd_real::_nan) : sqrt(value);
}

KUSABI_INLINE Pack root(const Pack& pack) {
  return Pack::Lanes{std::sqrt(pack[0]), std::sqrt(pack[1]), std::sqrt(pack[2]),
                     std::sqrt(pack[3])};
}

/// The larger number in each lane; b where the two cannot be compared.
KUSABI_INLINE Pack larger(const Pack& a, const Pack& b) {
  return (a > b).bits ? a.values : b.values;
}

template <Alone Real>
KUSABI_INLINE Real larger(const Real& a, const Real& b) {
  return a > b ? a : b;
}

/// In each lane `yes` where the number at `chosen` is positive and `no` where it is not.
KUSABI_INLINE Pack where(const double* chosen, const Pack& yes, const Pack& no) {
  return (load(chosen) > 0.0).bits ? yes.values : no.values;
}

template <Alone Real>
KUSABI_INLINE Real where(const Real* chosen, const std::type_identity_t<Real>& yes,
                         const std::type_identity_t<Real>& no) {
  return *chosen > 0.0 ? yes : no;
}

/// The largest lane.
KUSABI_INLINE double largest(const Pack& pack) {
  const double even = pack[0] > pack[2] ? pack[0] : pack[2];
  const double odd = pack[1] > pack[3] ? pack[1] : pack[3];
  return even > odd ? even : odd;
}

template <Alone Real>
KUSABI_INLINE Real largest(const Real& number) {
  return number;
}

/// The sum of the lanes.
KUSABI_INLINE double total(const Pack& pack) {
  return (pack[0] + pack[2]) + (pack[1] + pack[3]);
}

template <Alone Real>
KUSABI_INLINE Real total(const Real& number) {
  return number;
}

/// The sums of as many packs as there are lanes, a lane each.
KUSABI_INLINE Pack totals(const Pack (&packs)[lanes<double>]) {
  const Pack::Lanes a = packs[0].values, b = packs[1].values;
  const Pack::Lanes c = packs[2].values, d = packs[3].values;
  const Pack::Lanes ab =
      __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Pack::Lanes cd =
      __builtin_shufflevector(c, d, 0, 4, 2, 6) + __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}

template <Alone Real>
KUSABI_INLINE Real totals(const Real (&numbers)[1]) {
  return numbers[0];
}

/// True if the comparison holds in all lanes.
KUSABI_INLINE bool all(const Answers& answers) {
  return (answers.bits[0] & answers.bits[1] & answers.bits[2] & answers.bits[3]) != 0;
}

KUSABI_INLINE bool all(bool answer) {
  return answer;
}

}  // namespace kusabi::conic
