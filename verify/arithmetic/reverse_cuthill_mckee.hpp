// Order of unknowns with a small matrix profile.
#pragma once

#include <cstddef>
#include <vector>

namespace kusabi::verify {

/// The reverse Cuthill-McKee order, which gives neighbours close numbers.
/// @param neighbours of each unknown
/// @return the unknowns in their new order
std::vector<std::size_t> reverse_cuthill_mckee(
    const std::vector<std::vector<std::size_t>>& neighbours);

}  // namespace kusabi::verify
