// How far apart the numbers taken for zero and those taken for something else were.
//
// Whether a normal displacement u_n = sum_k a_k x_k (x >= 0) vanishes decides which rays there are.
// The quantity that is compared is |u_n| / sum_k |a_k| x_k, the share of the sum that cancellation
// leaves: a number from 0 to 1 that units and scale do not change. On sound data zeros are at 1e-15
// or so and everything else is far above. The answer is right only if there is such a gap; it is
// reported, and where it is too small the answer is marked.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace kusabi::rays {

/// A relative displacement up to this is zero. On trusses of up to 16 rows what rounding leaves of
/// zeros is below 1e-12 (1e-9 would be too little without extended precision), and the least of
/// the others, which falls tenfold with every row or two, above 1e-10.
inline constexpr double zero_tolerance = 1e-11;

/// A relative displacement within this factor of the tolerance, to either side, is too close to
/// say.
inline constexpr double doubtful_factor = 10;

struct Health {
  double largest_zero = 0;      ///< of the relative displacements that were taken for zero
  double smallest_nonzero = 1;  ///< of the others
  std::uint64_t doubtful = 0;   ///< how many were too close to the tolerance to be sure

  /// Decides on one relative displacement, from -1 to 1, and remembers it. @return -1, 0 or 1
  int sign(double relative) {
    const double size = std::abs(relative);
    if (size > zero_tolerance / doubtful_factor && size < zero_tolerance * doubtful_factor) {
      ++doubtful;
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
    doubtful += other.doubtful;
    return *this;
  }

  /// Whether zero and nonzero can be told apart.
  bool sound() const { return doubtful == 0; }

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& largest_zero& smallest_nonzero& doubtful;
  }
};

}  // namespace kusabi::rays
