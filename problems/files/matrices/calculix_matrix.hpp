// Stiffnesses as CalculiX writes them, with the node and the direction of each row: the
// substructure of *SUBSTRUCTURE GENERATE (in the words of Abaqus, *USER ELEMENT and *MATRIX), and
// the whole matrix of *FREQUENCY, SOLVER=MATRIXSTORAGE.
#pragma once

#include <string>
#include <string_view>

#include "problems/files/matrices/matrix_data.hpp"

namespace kusabi::problems {

/// A substructure, with a warning that CalculiX 2.20 has not condensed it: `*USER ELEMENT` with the
/// nodes in comments after it, and `*MATRIX, TYPE=STIFFNESS`, the lower triangle row by row. Other
/// matrices are left out, with a warning.
/// @param file how errors name it
/// @throws InputError with file and line
MatrixData read_substructure(std::string_view text, const std::string& file);

/// One triangle, a line "row column value" each, of a `.sti` file, and in the `.dof` file beside it
/// a line "node.direction" for each row.
/// @throws InputError with file and line
MatrixData read_stored_matrix(std::string_view text, const std::string& file, std::string_view dofs,
                              const std::string& dof_file);

}  // namespace kusabi::problems
