// Reader of mixed zero-one programs in MPS format, free or fixed. docs/mps.md specifies the
// dialect; a line that readers interpret differently is refused or reported.
#pragma once

#include <string>
#include <string_view>

#include "solvers/linear/program_file.hpp"

namespace kusabi::linear {

/// Magnitude from which a bound or right-hand side is infinite (as in HiGHS, CPLEX and SCIP).
inline constexpr double infinite_in_files = 1e20;

/// @param text the whole file, uncompressed  @param file its name in messages
/// @throws support::InputError `FILE:LINE: fault; expected ...`
ProgramFile parse_mps(std::string_view text, const std::string& file);

}  // namespace kusabi::linear
