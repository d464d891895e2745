// Matrix as its file has it, and the conditions for a stiffness matrix.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/SparseCore>

namespace kusabi::problems {

/// Maximum number of rows of a matrix from a file.
inline constexpr int max_matrix_rows = 3'000'000;

/// Tolerance for the difference of transposed entries, relative to the square root of the product
/// of their diagonal entries: the effect of different orders of summation in doubles.
inline constexpr double largest_asymmetry = 1e-12;

/// Numbers with at most this many digits are taken as exact. Numbers with more digits, up to
/// `max_rounded_digits`, are taken as rounded by the program that wrote them.
inline constexpr int max_exact_digits = 5;
inline constexpr int max_rounded_digits = 15;

struct MatrixEntry {
  int row;  ///< counted from 0, as is the column
  int column;
  double value;
  int line;
};

/// Meaning of a row in a file of CalculiX.
struct MatrixRow {
  int node;       ///< its tag
  int direction;  ///< 1, 2, 3: the axes; more: a rotation
  int line;
};

struct MatrixData {
  std::string file;  ///< name in messages
  int size = 0;
  int size_line = 1;          ///< its line
  bool one_triangle = false;  ///< the other triangle follows by symmetry
  std::vector<MatrixEntry> entries;
  int digits = 0;  ///< maximum number of significant digits of numbers with a fraction
  std::string rows_file;
  std::vector<MatrixRow> rows;        ///< empty, or one for each row
  std::vector<std::string> warnings;  ///< one line each

  /// Adds an entry, whose number is `text` in the file.
  void add(MatrixEntry entry, std::string_view text);
};

/// A symmetric matrix with positive diagonal.
struct SymmetricMatrix {
  Eigen::SparseMatrix<double> matrix;    ///< both triangles, exactly symmetric
  double rounding = 0;                   ///< bound of the relative rounding error of each number
  std::optional<std::string> warning{};  ///< set if it was made symmetric
};

/// @throws InputError at an entry that is repeated, differs from its transposed entry, or is on
///         the diagonal and not positive
SymmetricMatrix symmetric_matrix(MatrixData data);

}  // namespace kusabi::problems
