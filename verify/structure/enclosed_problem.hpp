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

/// `condensed_stiffness` with grounding springs at the candidates, which are subtracted exactly
/// afterwards, and with grounding springs for rigid-body modes that displace no candidate, in which
/// no force acts.
std::variant<EnclosedProblem, std::string> enclosed_problem(const Structure& structure,
                                                            const support::LongWork& work = {});

/// A load: condensed, and its work on the rigid-body modes, exactly.
struct EnclosedLoad {
  CondensedLoad condensed;
  LoadWork work;
  /// By candidate: whether the load acts on the structure connected with it.
  std::vector<bool> acts;
};

struct LoadedEnclosure {
  EnclosedProblem problem;
  std::vector<EnclosedLoad> loads;  ///< dead, reference
};

/// The same with the dead and the reference load of the structure. If a load does work on a mode
/// that displaces no candidate, it is in no equilibrium, and its condensed forces mean nothing.
std::variant<LoadedEnclosure, std::string> enclosed_loads(const Structure& structure,
                                                          const support::LongWork& work = {});

/// A power of two about as large as the stiffness of the stiffest bar or element.
double typical_stiffness(const Structure& structure);

}  // namespace kusabi::verify
