// Symmetric matrices in Matrix Market files, a common format of numerical software
// (docs/problem-files.md, docs/export.md).
#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <string_view>

#include <Eigen/Core>

#include "problems/files/matrices/matrix_data.hpp"

namespace kusabi::problems {

/// True if a text begins with the banner of a Matrix Market file.
bool is_matrix_market(std::string_view text);

/// A square matrix, coordinate or array, real or integer, symmetric or general.
/// @param file name in messages
/// @throws InputError with file and line
MatrixData read_matrix_market(std::string_view text, const std::string& file);

/// Writes the lower triangle by columns (`array real symmetric`) with 17 digits, which reproduce
/// each double exactly.
/// @param matrix exactly symmetric
/// @param comments lines at the top of the file
void write_matrix_market(std::ostream& out, const Eigen::MatrixXd& matrix,
                         std::span<const std::string> comments);

}  // namespace kusabi::problems
