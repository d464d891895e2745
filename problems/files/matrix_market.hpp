// Symmetric matrices as Matrix Market files, which programs of numerical mathematics read
// (docs/export.md).
#pragma once

#include <iosfwd>
#include <span>
#include <string>

#include <Eigen/Core>

namespace kusabi::problems {

/// The lower triangle, column by column (`array real symmetric`), with 17 digits, so that it is
/// read back to the last bit.
/// @param matrix symmetric to the last bit
/// @param comments lines at the top of the file
void write_matrix_market(std::ostream& out, const Eigen::MatrixXd& matrix,
                         std::span<const std::string> comments);

}  // namespace kusabi::problems
