// Least-squares correction of forces that are in equilibrium up to rounding.
#pragma once

#include <optional>
#include <vector>

#include "verify/arithmetic/elimination.hpp"

namespace kusabi::verify {

/// Changes the numbers c by the smallest amount, relative to `room`, so that the sum of c_k
/// rows[k] is zero.
/// @param numbers c, one for each row
/// @param room of each number, the unit in which its change is measured; zero: unchanged
/// @return nothing if there is no such change
std::optional<Rationals> balanced(const std::vector<Rationals>& rows, Rationals numbers,
                                  const std::vector<double>& room);

/// Like balanced(), up to rounding: combinations of equations in which the numbers have almost no
/// part are not corrected, since they would require large changes.
std::optional<Rationals> nearly_balanced(const std::vector<Rationals>& rows, Rationals numbers,
                                         const std::vector<double>& room);

}  // namespace kusabi::verify
