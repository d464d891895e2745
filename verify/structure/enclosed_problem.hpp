// Enclosure of K of a structure with unconstrained bodies, and their rigid-body modes.
#pragma once

#include <string>
#include <variant>

#include "support/stop.hpp"
#include "verify/arithmetic/exact.hpp"
#include "verify/structure/condensation.hpp"
#include "verify/structure/contact_motions.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::verify {

/// Data of the proofs, over all candidates.
struct EnclosedProblem {
  EnclosedMatrix stiffness;  ///< K, dm x dm
  ContactMotions motions;    ///< G with K G = 0
};

/// `condensed_stiffness` with two kinds of grounding springs: those at the candidates are
/// subtracted exactly afterwards; those for rigid-body modes that displace no candidate carry no
/// force.
std::variant<EnclosedProblem, std::string> enclosed_problem(const Structure& structure,
                                                            const support::LongWork& work = {});

/// A load: condensed, and its work on the rigid-body modes, exactly.
struct EnclosedLoad {
  CondensedLoad condensed;
  LoadWork work;
  /// By candidate: true if the load acts on its connected component.
  std::vector<bool> acts;
};

struct LoadedEnclosure {
  EnclosedProblem problem;
  std::vector<EnclosedLoad> loads;  ///< dead, reference
};

/// The same with the dead and the reference load of the structure. A load that does work on a mode
/// that displaces no candidate is balanced by no reaction; its condensed forces are undefined.
std::variant<LoadedEnclosure, std::string> enclosed_loads(const Structure& structure,
                                                          const support::LongWork& work = {});

/// A power of two about as large as the stiffness of the stiffest bar or element.
double typical_stiffness(const Structure& structure);

}  // namespace kusabi::verify
