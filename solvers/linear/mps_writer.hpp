// Writer of a mixed zero-one program as free MPS, which all solvers of such programs read
// (docs/export.md).
#pragma once

#include <iosfwd>
#include <span>
#include <string>

#include "solvers/linear/linear_program.hpp"

namespace kusabi::linear {

/// Writes numbers such that they are read back exactly; for a row with two different bounds, the
/// upper one is written as a range and may be rounded. Rows without bounds are omitted. Columns
/// (and rows) are named c1, c2, ... (r1, r2, ...) if a name is empty, occurs twice, or is not
/// accepted by all readers: it must consist of at most 255 ASCII characters without blanks, and
/// must not begin with $ or '.
/// @param comments lines at the top of the file
void write_mps(std::ostream& out, const MixedProgram& mixed, std::span<const std::string> comments);

}  // namespace kusabi::linear
