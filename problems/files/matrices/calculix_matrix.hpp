// Stiffness matrices written by CalculiX, with the node and the direction of each row: the
// substructure of *SUBSTRUCTURE GENERATE (in Abaqus terms *USER ELEMENT and *MATRIX), and the whole
// matrix of *FREQUENCY, SOLVER=MATRIXSTORAGE.
#pragma once

#include <string>
#include <string_view>

#include "problems/files/matrices/matrix_data.hpp"

namespace kusabi::problems {

/// A substructure: `*USER ELEMENT` with its nodes in the comments that follow, and `*MATRIX,
/// TYPE=STIFFNESS`, the lower triangle by rows. There is a warning that CalculiX 2.20 does not
/// condense it. Other matrices are ignored with a warning.
/// @param file name in messages
/// @throws InputError with file and line
MatrixData read_substructure(std::string_view text, const std::string& file);

/// One triangle, a line "row column value" for each entry, of a `.sti` file, and in the
/// corresponding `.dof` file a line "node.direction" for each row.
/// @throws InputError with file and line
MatrixData read_stored_matrix(std::string_view text, const std::string& file, std::string_view dofs,
                              const std::string& dof_file);

}  // namespace kusabi::problems
