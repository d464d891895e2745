// Proof by a quadratic form that nothing is wedged in a block: the form is not below zero in any
// wedged configuration, but negative definite for reactions in equilibrium.
#pragma once

#include <span>

#include "verify/wedged/block_model.hpp"
#include "verify/wedged/proof_result.hpp"

namespace kusabi::verify {

/// @param numbers m^2 multipliers of products, (d - 1) m^2 of slips, m of squares and, with
///        motions, m^2 of products of displacements
/// @pre model.min_eigenvalue()
[[nodiscard]] ProofResult prove_by_form(const BlockModel& model, std::span<const double> numbers);

}  // namespace kusabi::verify
