// Numbers of 104 bits, and how far each kind of number that is computed with may be trusted.
//
// They are sums of two doubles (the QD library of Hida, Li and Bailey). A product costs 14 ns where
// one of long doubles costs 7, one of __float128 70 and one of boost's cpp_bin_float_quad 110.
#pragma once

#include <cmath>
#include <limits>

#include <Eigen/Core>
#include <qd/dd_real.h>

namespace Eigen {

/// What Eigen asks of a scalar.
template <>
struct NumTraits<dd_real> : GenericNumTraits<dd_real> {
  using Real = dd_real;
  using NonInteger = dd_real;
  using Nested = dd_real;
  using Literal = double;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 2,
    AddCost = 20,
    MulCost = 30
  };
  static dd_real epsilon() { return 0x1p-104; }
  static dd_real dummy_precision() { return 0x1p-90; }
  static dd_real highest() { return std::numeric_limits<double>::max(); }
  static dd_real lowest() { return -std::numeric_limits<double>::max(); }
  static int digits10() { return 31; }
};

namespace internal {

/// Rounds to the nearest double: the first of the two.
template <>
struct cast_impl<dd_real, double> {
  static double run(const dd_real& number) { return number.x[0]; }
};

template <>
struct cast_impl<dd_real, long double> {
  static long double run(const dd_real& number) {
    return static_cast<long double>(number.x[0]) + static_cast<long double>(number.x[1]);
  }
};

template <>
struct cast_impl<long double, dd_real> {
  static dd_real run(const long double& number) {
    const auto first = static_cast<double>(number);
    return {first, static_cast<double>(number - static_cast<long double>(first))};
  }
};

}  // namespace internal
}  // namespace Eigen

namespace kusabi::numbers {

using Precise = dd_real;
using PreciseMatrix = Eigen::Matrix<Precise, Eigen::Dynamic, Eigen::Dynamic>;
using PreciseVector = Eigen::Matrix<Precise, Eigen::Dynamic, 1>;

/// A sum of two numbers is wrong by at most this much of the sum of their sizes, a product, a
/// quotient or a root by at most this much of itself. (QD adds without a last carry: where numbers
/// cancel, the error is relative to what is added.)
template <class Real>
inline constexpr double unit_roundoff = 0;
template <>
inline constexpr double unit_roundoff<double> = 0x1p-53;
/// A double's, should the machine have no more.
template <>
inline constexpr double unit_roundoff<long double> =
    static_cast<double>(std::numeric_limits<long double>::epsilon()) / 2;
/// Of 2^-104 with three bits to spare: products leave out the least of their four parts.
template <>
inline constexpr double unit_roundoff<Precise> = 0x1p-101;

/// Rounded to the nearest double, or almost.
inline double rounded(double number) {
  return number;
}
inline double rounded(long double number) {
  return static_cast<double>(number);
}
inline double rounded(const Precise& number) {
  return number.x[0];
}

}  // namespace kusabi::numbers
