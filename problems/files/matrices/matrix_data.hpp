// A matrix as a file has it, before anything is made of it, and what must hold for it to be the
// stiffness of a body.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/SparseCore>

namespace kusabi::problems {

/// Most rows of a matrix from a file.
inline constexpr int most_matrix_rows = 3'000'000;

/// Two entries that should be equal may differ by so much of the root of the product of their
/// diagonal entries: what the rounding of another order of summation leaves in doubles.
inline constexpr double largest_asymmetry = 1e-12;

/// Numbers written with so many digits or fewer are taken as meant; of those with more, up to
/// `most_rounded_digits`, a program has written as many digits as it was told to, and has rounded.
inline constexpr int most_exact_digits = 5;
inline constexpr int most_rounded_digits = 15;

struct MatrixEntry {
  int row;  ///< from 0, like the next
  int column;
  double value;
  int line;
};

/// What a row is, where the file says it: CalculiX does.
struct MatrixRow {
  int node;       ///< its tag
  int direction;  ///< 1, 2, 3: the axes; more: a rotation
  int line;
};

struct MatrixData {
  std::string file;  ///< how errors name it
  int size = 0;
  int size_line = 1;          ///< where that stands
  bool one_triangle = false;  ///< the entries of the other one are not there, but meant
  std::vector<MatrixEntry> entries;
  int digits = 0;  ///< most significant digits that a number is written with, if it has a fraction
  std::string rows_file;
  std::vector<MatrixRow> rows;        ///< empty, or one a row
  std::vector<std::string> warnings;  ///< a line each

  /// Adds an entry, whose number stands in the file as `text`.
  void add(MatrixEntry entry, std::string_view text);
};

/// A matrix that may be a stiffness.
struct SymmetricMatrix {
  Eigen::SparseMatrix<double> matrix;    ///< both triangles, symmetric to the last bit
  double rounding = 0;                   ///< what each number may be off by, relative to itself
  std::optional<std::string> warning{};  ///< that it was made symmetric
};

/// @throws InputError at an entry that is there twice, has another one in its transposed place, or
///         is on the diagonal and not positive
SymmetricMatrix symmetric_matrix(MatrixData data);

}  // namespace kusabi::problems
