// The rules for what is uncertain about the dead load of a structure.
#pragma once

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// Smallest and largest weight of an uncertain component: relative to the others, of one size.
inline constexpr double smallest_weight = 1e-6;
inline constexpr double largest_weight = 1e6;

/// Checks the parameters: nodes and axes, that none acts on supports alone, weights, names, and
/// that nothing is named twice. Different parameters may share components, and one may be a
/// multiple of another. @throws InputError at the first fault, in the order of the file
void check_uncertainty(const Structure& structure);

}  // namespace kusabi::problems
