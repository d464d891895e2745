// Proof in doubles that a quadratic form is negative definite, with bounds of all roundings and of
// the error of F.
#pragma once

#include <span>

#include "nodes/wedged/quadratic/quadratic_form.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// True if it is proved that nothing is wedged with this friction or less.
/// @param block a problem of one block  @param friction of its candidates
/// @param multipliers any doubles; those that must not be negative are checked
bool form_proves_infeasible(const problems::WedgedProblem& block, std::span<const double> friction,
                            const QuadraticMultipliers& multipliers);

}  // namespace kusabi::wedged
