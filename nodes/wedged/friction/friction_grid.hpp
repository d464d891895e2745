// Grid of friction coefficients for brackets: the multiples of a width.
//
// The width is a decimal, and so are its multiples: 60962948 x 1e-8 is the double nearest to
// 0.60962948, not the product of two doubles, which may differ.
#pragma once

#include <cstdint>

namespace kusabi::wedged {

class FrictionGrid {
 public:
  /// @param width > 0
  explicit FrictionGrid(double width);

  [[nodiscard]] double width() const { return width_; }

  /// Multiple x width, where the width is its decimal if that has few digits, rounded to nearest.
  /// Nondecreasing in the multiple.
  [[nodiscard]] double at(std::int64_t multiple) const;

 private:
  double width_;
  std::int64_t numerator_ = 0;  // of the width as a decimal fraction; 0: too many digits
  double denominator_ = 1;      // a power of ten, exact
};

}  // namespace kusabi::wedged
