// The combination of a few columns that is nearest to a vector, in plain double precision: to guess
// with.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace kusabi::verify {

/// x with |A x - b| least. @return nothing if the columns depend on each other, or nearly
/// @param matrix A, row by row, of as many rows as b has numbers
std::optional<std::vector<double>> least_squares(std::span<const double> matrix,
                                                 std::span<const double> right);

}  // namespace kusabi::verify
