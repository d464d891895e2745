// Test for unboundedness of a program without an optimum.
#pragma once

#include "solvers/linear/linear_program.hpp"
#include "support/stop.hpp"

namespace kusabi::zero_one {

/// True if there is a direction, found in 104 bits, along which the objective decreases and which
/// no row, bound or binary limits: the program is then unbounded if it has a point.
bool decreases_without_bound(const linear::MixedProgram& mixed, const support::Stop& stop = {});

}  // namespace kusabi::zero_one
