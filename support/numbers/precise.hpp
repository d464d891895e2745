// Precise: double-double numbers of 104 bits (QD library of Hida, Li and Bailey), and the unit
// roundoff of each scalar type.
//
// A product takes 14 ns; one of long doubles takes 7 ns, one of __float128 70 ns and one of boost's
// cpp_bin_float_quad 110 ns.
#pragma once

#include <cmath>
#include <limits>

#include <Eigen/Core>
#include <qd/dd_real.h>

namespace Eigen {

/// Scalar traits for Eigen.
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

/// Rounds to the nearest double, which is the first component.
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

/// Bound of relative rounding errors. A sum of two numbers has an error of at most this times the
/// sum of their absolute values; a product, a quotient or a root at most this times the result.
/// (The addition of QD omits the last carry: with cancellation its error is relative to the
/// summands.)
template <class Real>
inline constexpr double unit_roundoff = 0;
template <>
inline constexpr double unit_roundoff<double> = 0x1p-53;
/// Equal to that of double on machines where long double is double.
template <>
inline constexpr double unit_roundoff<long double> =
    static_cast<double>(std::numeric_limits<long double>::epsilon()) / 2;
/// 2^-104 with a margin of three bits: products omit the least of their four partial products.
template <>
inline constexpr double unit_roundoff<Precise> = 0x1p-101;

/// Nearest double, up to the rounding of the scalar.
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
