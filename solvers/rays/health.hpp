// Health: the gap between numbers taken for zero and numbers taken for nonzero.
//
// The rays depend on whether a normal displacement u_n = sum_k a_k x_k (x >= 0) vanishes. The test
// compares |u_n| / sum_k |a_k| x_k, the share of the sum that remains after cancellation: a number
// from 0 to 1 that does not depend on units and scale. On sound data zeros are at about 1e-15 and
// all other values far above. The answer is right only if there is such a gap; the gap is reported,
// and an answer with too small a gap is marked.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace kusabi::rays {

/// Threshold of a zero relative displacement. On trusses of up to 16 rows the rounding of zeros is
/// below 1e-12 (in doubles it would exceed 1e-9), and the least nonzero value, which decreases
/// tenfold with every row or two, above 1e-10.
inline constexpr double zero_tolerance = 1e-11;

/// Factor around the threshold within which a relative displacement is numerically undecided.
inline constexpr double undecided_factor = 10;

struct Health {
  double largest_zero = 0;      ///< of the relative displacements taken for zero
  double smallest_nonzero = 1;  ///< of the others
  std::uint64_t undecided = 0;  ///< number of numerically undecided values

  /// Classifies one relative displacement, from -1 to 1, and records it. @return -1, 0 or 1
  int sign(double relative) {
    const double size = std::abs(relative);
    if (size > zero_tolerance / undecided_factor && size < zero_tolerance * undecided_factor) {
      ++undecided;
    }
    if (size <= zero_tolerance) {
      largest_zero = std::max(largest_zero, size);
      return 0;
    }
    smallest_nonzero = std::min(smallest_nonzero, size);
    return relative > 0 ? 1 : -1;
  }

  Health& operator+=(const Health& other) {
    largest_zero = std::max(largest_zero, other.largest_zero);
    smallest_nonzero = std::min(smallest_nonzero, other.smallest_nonzero);
    undecided += other.undecided;
    return *this;
  }

  /// True if zero and nonzero values are separated.
  bool sound() const { return undecided == 0; }

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& largest_zero& smallest_nonzero& undecided;
  }
};

}  // namespace kusabi::rays
