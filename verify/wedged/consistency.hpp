// Consistency of a certificate with a structure: candidates, friction, blocks and K.
#pragma once

#include <string>
#include <variant>

#include "verify/arithmetic/exact.hpp"
#include "verify/structure/contact_motions.hpp"
#include "verify/structure/enclosed_problem.hpp"
#include "verify/structure/structure.hpp"
#include "verify/wedged/certificate.hpp"
#include "verify/wedged/lines.hpp"

namespace kusabi::verify {

/// Tolerance of the certificate's K relative to the largest diagonal entries of the two candidates:
/// a K in double precision has rounding errors of 1e-16 times the condition number of the whole
/// stiffness. No proof uses the certificate's K, so smaller differences are harmless.
inline constexpr double stiffness_tolerance = 1e-6;

/// Tolerance of the rigid-body modes, relative to the largest entry of each.
inline constexpr double motion_tolerance = 1e-6;

/// Data of the structure for the proofs.
struct ConsistentStructure {
  EnclosedMatrix stiffness;  ///< of the structure
  ContactMotions motions;    ///< of its unconstrained bodies
  double friction = 0;       ///< the coefficient to which those of the candidates are relative
};

/// Computes K of the structure and compares.
/// @return otherwise a sentence with the first difference
std::variant<ConsistentStructure, std::string> consistency(const Certificate& certificate,
                                                           const Structure& structure);

struct ConsistentLoads {
  LoadedEnclosure enclosure;
  double friction = 0;  ///< as above
};

/// Computes K and the loads of the structure; compares all but K, which certificates of states
/// under load do not have.
std::variant<ConsistentLoads, std::string> consistency_under_load(const Certificate& header,
                                                                  const Structure& structure);

}  // namespace kusabi::verify
