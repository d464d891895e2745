// Mixed zero-one programs in MPS format, free or fixed. Readers differ in what they make of a file;
// what is done here is said in docs/mps.md, and what may mean two things is refused with its line.
#pragma once

#include <string>
#include <string_view>

#include "solvers/linear/program_file.hpp"

namespace kusabi::linear {

/// A bound or right-hand side this large is none at all (HiGHS, CPLEX and SCIP agree).
inline constexpr double infinite_in_files = 1e20;

/// @param text the whole file, unpacked; `file` is its name in messages
/// @throws support::InputError `FILE:LINE: what is wrong; expected ...`
ProgramFile parse_mps(std::string_view text, const std::string& file);

}  // namespace kusabi::linear
