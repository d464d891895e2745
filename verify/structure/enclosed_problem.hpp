// Enclosure of K of a structure with unconstrained bodies, and their rigid-body modes.
#pragma once

#include <string>
#include <variant>

#include "support/stop.hpp"
#include "verify/arithmetic/exact.hpp"
#include "verify/structure/contact_motions.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::verify {

/// Data of the proofs, over all candidates.
struct EnclosedProblem {
  EnclosedMatrix stiffness;  ///< K, dm x dm
  ContactMotions motions;    ///< G with K G = 0
};

/// `condensed_stiffness` with grounding springs at the candidates, which are subtracted exactly
/// afterwards, and with grounding springs for rigid-body modes that displace no candidate, in which
/// no force acts.
std::variant<EnclosedProblem, std::string> enclosed_problem(const Structure& structure,
                                                            const support::LongWork& work = {});

/// A power of two about as large as the stiffness of the stiffest bar or element.
double typical_stiffness(const Structure& structure);

}  // namespace kusabi::verify
