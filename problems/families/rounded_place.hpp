// Coordinates of generated structures, short enough to be read in a file.
#pragma once

#include <cmath>

namespace kusabi::problems {

/// Rounds a coordinate in metres to a picometre, so that 3 x 0.35 is 1.05 in the file.
inline double rounded_place(double coordinate) {
  return std::round(coordinate * 1e12) / 1e12;
}

}  // namespace kusabi::problems
