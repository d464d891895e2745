// Enclosure of K of equations (3) and (6) of the wedged paper, computed from the structure: a
// matrix of about 160 binary digits and a proved bound of its distance from the exact K.
// docs/theory/proofs.md derives it.
#pragma once

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "support/stop.hpp"
#include "verify/arithmetic/exact.hpp"
#include "verify/structure/candidate_rows.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::verify {

/// K, dm x dm, by candidates, each with n, t1[, t2]; exactly zero between candidates that are not
/// connected. Otherwise a sentence with the reason why K is not enclosed. A displacement along
/// which a roller supports a candidate has a grounding spring, so that K is definite.
/// @param springs stiffness added to K along every displacement of a candidate, except supported
///        ones
/// @pre no candidate is supported along its normal
/// @throws support::Stopped if the program is asked to stop
std::variant<EnclosedMatrix, std::string> condensed_stiffness(const Structure& structure,
                                                              double springs = 0,
                                                              const support::LongWork& work = {});

/// A load condensed to the displacements of the candidates: E'f with E = [I; -X], dm numbers.
struct CondensedLoad {
  DyadicList forces;
  Dyadic error;  ///< bound of the Euclidean norm of their error
};

struct LoadedStiffness {
  EnclosedMatrix stiffness;
  std::vector<CondensedLoad> loads;  ///< as they were given
};

/// The same with loads. @param loads at most d
std::variant<LoadedStiffness, std::string> loaded_stiffness(const Structure& structure,
                                                            std::span<const ForceList> loads,
                                                            double springs = 0,
                                                            const support::LongWork& work = {});

}  // namespace kusabi::verify
