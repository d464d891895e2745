// Proof of an answer of a linear program by a basis in rational numbers.
#pragma once

#include <optional>

#include "solvers/linear/exact_simplex.hpp"

namespace kusabi::linear {

/// The answer that a basis proves, or nothing: it may prove none, be singular, be too much work, or
/// the work is stopped.
/// @param too_much set to true if it is too much work  @param entering a nonbasic variable, rows before columns, whose edge may have no end; -1: none
std::optional<ExactSolution> proof_by_basis(const LinearProgram& program, const Basis& basis,
                                            int entering, const support::Stop& stop,
                                            bool& too_much);

}  // namespace kusabi::linear
