// Linear least squares with few columns in double precision, for approximate solutions.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace kusabi::verify {

/// x that minimises |A x - b|. @return nothing if the columns are dependent up to rounding
/// @param matrix A, by rows, with as many rows as b has numbers
std::optional<std::vector<double>> least_squares(std::span<const double> matrix,
                                                 std::span<const double> right);

}  // namespace kusabi::verify
