// Whether a program without an optimum has none because its objective falls for ever.
#pragma once

#include "solvers/linear/linear_program.hpp"
#include "support/stop.hpp"

namespace kusabi::zero_one {

/// Whether there is a direction, found in 104 bits, that no row, bound or binary ends and along
/// which the objective falls: if there is a point at all, the program is unbounded then.
bool falls_for_ever(const linear::MixedProgram& mixed, const support::Stop& stop = {});

}  // namespace kusabi::zero_one
