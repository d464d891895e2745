// K of equations (3) and (6) of the wedged paper, computed from a structure anew and enclosed: a
// matrix of some 160 digits and a proved bound of its distance from the K that the structure has.
// docs/theory/proofs.md derives it.
#pragma once

#include <string>
#include <variant>

#include "verify/exact.hpp"
#include "verify/structure.hpp"

namespace kusabi::verify {

/// K, dm x dm, candidate by candidate, in each n, t1[, t2]; exactly zero between candidates that
/// nothing connects. Or a sentence that says why it could not be enclosed.
/// @pre no candidate is supported
std::variant<EnclosedMatrix, std::string> condensed_stiffness(const Structure& structure);

}  // namespace kusabi::verify
