// An order of unknowns that keeps the profile of their matrix small.
#pragma once

#include <cstddef>
#include <vector>

namespace kusabi::verify {

/// By the method of Cuthill and McKee, backwards: neighbours get numbers close to each other.
/// @param neighbours of each unknown
/// @return the unknowns in their new order
std::vector<std::size_t> narrow_order(const std::vector<std::vector<std::size_t>>& neighbours);

}  // namespace kusabi::verify
