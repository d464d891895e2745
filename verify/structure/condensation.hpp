// K of equations (3) and (6) of the wedged paper, computed from a structure anew and enclosed: a
// matrix of some 160 digits and a proved bound of its distance from the K that the structure has.
// docs/theory/proofs.md derives it.
#pragma once

#include <string>
#include <variant>

#include "support/stop.hpp"
#include "verify/arithmetic/exact.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::verify {

/// K, dm x dm, candidate by candidate, in each n, t1[, t2]; exactly zero between candidates that
/// nothing connects. Or a sentence that says why it could not be enclosed.
/// A displacement along which a roller holds a candidate has a spring of its own (K is definite
/// so).
/// @param springs added to K along every displacement of a candidate, but for those held
/// @pre no candidate is held along its normal
/// @throws support::Stopped if an end is asked for
std::variant<EnclosedMatrix, std::string> condensed_stiffness(const Structure& structure,
                                                              double springs = 0,
                                                              const support::LongWork& work = {});

}  // namespace kusabi::verify
