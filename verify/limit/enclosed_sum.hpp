// Sum of products in about twice double precision, with a bound of its error: T. Ogita, S. Rump,
// S. Oishi, Accurate sum and dot product, SIAM J. Sci. Comput. 26 (2005) 1955-1988, Algorithm 5.3.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>

#include "verify/arithmetic/exact.hpp"
#include "verify/limit/equilibrium_correction.hpp"

namespace kusabi::verify {

/// A number within `error` of high + low, where |low| <= 2^-52 |high|.
struct TwoDoubles {
  double high = 0;
  double low = 0;
  double error = 0;

  /// @param error of the value, >= 0
  static TwoDoubles of(const Dyadic& value, const Dyadic& error) {
    const double high = value.nearest();
    const auto rest = value - Dyadic(high);
    const double low = rest.nearest();
    return {high, low, double_above(absolute(rest - Dyadic(low)) + error)};
  }
};

/// A sum of products, computed in double precision with a running correction.
class EnclosedSum {
 public:
  /// Adds a * b.
  void add(const TwoDoubles& a, double b) {
    if ((a.high == 0 && a.error == 0) || b == 0) return;
    const double product = a.high * b;
    const double sum = sum_ + product;
    const double part = sum - sum_;
    low_ += std::fma(a.high, b, -product) + ((sum_ - (sum - part)) + (product - part)) + a.low * b;
    sum_ = sum;
    size_ += std::abs(product);
    error_ += a.error * std::abs(b);
    ++terms_;
  }

  /// Upper bound of |sum|; nothing if the computed sum cannot be distinguished from zero.
  [[nodiscard]] std::optional<double> magnitude_above() const {
    if (terms_ == 0) return 0;
    // A term has four roundings of numbers below (n + 4) 2^-53 times the size, n the number of
    // terms. Underflow is far below this bound for the minimum size.
    constexpr double min_size = 1e-200;
    const double roundings = static_cast<double>(terms_ + 2) * 0x1p-53;
    const double bound = 32 * roundings * roundings * size_;
    const double computed = std::abs(sum_ + low_);
    if (!(size_ >= min_size && computed > 2 * bound && std::isfinite(computed + error_))) return {};
    return (computed + bound + error_) * (1 + 8 * roundings);
  }

 private:
  double sum_ = 0;
  double low_ = 0;
  double size_ = 0;   // sum of the magnitudes of the products
  double error_ = 0;  // of the factors
  std::size_t terms_ = 0;
};

}  // namespace kusabi::verify
