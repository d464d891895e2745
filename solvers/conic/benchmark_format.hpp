// Conic programs as files in the Conic Benchmark Format, version 1, which solvers of second-order
// cone programs read (docs/export.md).
#pragma once

#include <iosfwd>
#include <span>
#include <string>

#include "solvers/conic/cone_program.hpp"

namespace kusabi::conic {

/// Numbers have 17 digits, so that they are read back to the last bit.
/// @param comments lines at the top of the file; they are cut at 500 characters, as readers may
void write_benchmark_format(std::ostream& out, const ConeProgram& program,
                            std::span<const std::string> comments);

}  // namespace kusabi::conic
