// Checks of the uncertain dead loads of a structure.
#pragma once

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// Smallest and largest weight of an uncertain component, relative to the others.
inline constexpr double smallest_weight = 1e-6;
inline constexpr double largest_weight = 1e6;

/// Share of the largest weight of a load below which a weight is a rounding error, as that of a
/// cosine, and may have any size.
inline constexpr double rounding_of_weights = 1e-12;

/// Checks the parameters: nodes and axes, that none acts on supports only, weights, names, and that
/// there are no duplicates. Different parameters may have components in common, and one may be a
/// multiple of another. @throws InputError at the first fault, in the order of the file
void check_uncertainty(const Structure& structure);

}  // namespace kusabi::problems
