// Symmetric matrices as Matrix Market files, which programs of numerical mathematics write and read
// (docs/problem-files.md, docs/export.md).
#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <string_view>

#include <Eigen/Core>

#include "problems/files/matrices/matrix_data.hpp"

namespace kusabi::problems {

/// Whether a text begins as a Matrix Market file does.
bool is_matrix_market(std::string_view text);

/// A square matrix, coordinate or array, real or integer, symmetric or general.
/// @param file how errors name it
/// @throws InputError with file and line
MatrixData read_matrix_market(std::string_view text, const std::string& file);

/// The lower triangle, column by column (`array real symmetric`), with 17 digits, so that it is
/// read back to the last bit.
/// @param matrix symmetric to the last bit
/// @param comments lines at the top of the file
void write_matrix_market(std::ostream& out, const Eigen::MatrixXd& matrix,
                         std::span<const std::string> comments);

}  // namespace kusabi::problems
