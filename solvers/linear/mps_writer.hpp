// A mixed zero-one program as free MPS, which every solver of such programs reads (docs/export.md).
#pragma once

#include <iosfwd>
#include <span>
#include <string>

#include "solvers/linear/linear_program.hpp"

namespace kusabi::linear {

/// Numbers are written so that they are read back to the last bit; of a row with two ends that
/// differ, the upper one is written as a range and may round. Rows without ends are left out. Names
/// of columns, and of rows, are numbers (c1, c2, ..., r1, r2, ...) if one of them is empty, comes
/// twice, or is none that all readers take: it must be of the letters, digits and signs of ASCII
/// without blanks, of 255 at most, and must not begin with $ or '.
/// @param comments lines at the top of the file
void write_mps(std::ostream& out, const MixedProgram& mixed, std::span<const std::string> comments);

}  // namespace kusabi::linear
