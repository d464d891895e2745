// The friction coefficients that brackets lie on: the multiples of a width.
//
// A width is a decimal that somebody wrote, and so are its multiples: 60962948 x 1e-8 is the double
// that 0.60962948 is read as, not the product of two doubles, which may be another.
#pragma once

#include <cstdint>

namespace kusabi::wedged {

class FrictionGrid {
 public:
  /// @param width > 0
  explicit FrictionGrid(double width);

  [[nodiscard]] double width() const { return width_; }

  /// Multiple x width; of the decimal that the width is written as, if that has few digits, to the
  /// nearest. Does not fall as the multiple grows.
  [[nodiscard]] double at(std::int64_t multiple) const;

 private:
  double width_;
  std::int64_t numerator_ = 0;  // of the width as a decimal fraction; 0: it is none to count with
  double denominator_ = 1;      // a power of ten, exactly
};

}  // namespace kusabi::wedged
