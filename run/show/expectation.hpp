// Expected cost of an analysis by the number of candidates, from measurements (bench/history.md).
#pragma once

#include <cstddef>
#include <string>

namespace kusabi::run {

/// A sentence on `critical` and one on the list of all patterns; empty without candidates.
/// @param dimension 2 or 3
std::string expectation(int dimension, std::size_t candidates);

}  // namespace kusabi::run
