// Whether a program without an optimum has none because its objective falls for ever.
#pragma once

#include "solvers/linear/linear_program.hpp"
#include "support/stop.hpp"

namespace kusabi::nodes {

/// Whether there is a direction, found in 104 bits, that no row, bound or binary ends and along
/// which the objective falls: if there is a point at all, the program is unbounded then.
bool falls_for_ever(const problems::MixedProgram& mixed, const linear::Stop& stop = {});

}  // namespace kusabi::nodes
