// Forces that nearly are in equilibrium, made so exactly.
#pragma once

#include <optional>
#include <vector>

#include "verify/arithmetic/elimination.hpp"

namespace kusabi::verify {

/// Changes the numbers c as little as can be, such that the sum of c_k rows[k] is zero.
/// @param numbers c, one a row
/// @param room of each number, in units of which a change is measured; zero: it stays
/// @return nothing if that can't be done
std::optional<Rationals> balanced(const std::vector<Rationals>& rows, Rationals numbers,
                                  const std::vector<double>& room);

/// The same but for what rounding leaves: combinations of equations in which the numbers have
/// hardly a part stay as they are, since they would take large changes.
std::optional<Rationals> nearly_balanced(const std::vector<Rationals>& rows, Rationals numbers,
                                         const std::vector<double>& room);

}  // namespace kusabi::verify
