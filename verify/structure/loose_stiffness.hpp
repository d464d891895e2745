// K of a structure whose bodies need not be held, enclosed, and their motions.
#pragma once

#include <string>
#include <variant>

#include "support/stop.hpp"
#include "verify/arithmetic/exact.hpp"
#include "verify/structure/contact_motions.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::verify {

/// What a block's proofs are about, of all candidates.
struct EnclosedProblem {
  EnclosedMatrix stiffness;  ///< K, dm x dm
  ContactMotions motions;    ///< G, with K G = 0
};

/// `condensed_stiffness`, with springs at the candidates that are taken away again, exactly, and
/// with springs for what no candidate sees, which carry no force.
std::variant<EnclosedProblem, std::string> enclosed_problem(const Structure& structure,
                                                            const support::LongWork& work = {});

/// A power of two about as large as the stiffest bar or element.
double typical_stiffness(const Structure& structure);

}  // namespace kusabi::verify
