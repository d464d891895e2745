// Writer of conic programs in the Conic Benchmark Format, version 1, which solvers of second-order
// cone programs read (docs/export.md).
#pragma once

#include <iosfwd>
#include <span>
#include <string>

#include "solvers/conic/cone_program.hpp"

namespace kusabi::conic {

/// Writes numbers with 17 digits, so that they are read back exactly.
/// @param comments lines at the top of the file, cut at 500 characters, the limit of some readers
void write_benchmark_format(std::ostream& out, const ConeProgram& program,
                            std::span<const std::string> comments);

}  // namespace kusabi::conic
