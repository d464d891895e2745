// Consistency of a certificate with a structure: candidates, friction, blocks, K and loads.
#pragma once

#include <string>
#include <variant>
#include <vector>

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

/// Tolerance of the recorded loads, relative to the largest force of each. No proof uses them.
inline constexpr double load_tolerance = 1e-6;

/// Forces at the candidates below this part of the load itself are zero: supports carry all of it, and
/// what is left is the rounding of 104 bits.
inline constexpr double carried_by_supports = 0x1p-80;

/// Data of the structure for the proofs.
struct ConsistentStructure {
  EnclosedMatrix stiffness;           ///< of the structure
  ContactMotions motions;             ///< of its unconstrained bodies
  std::vector<EnclosedLoad> loads{};  ///< dead, reference, if the certificate has loads
  double friction = 0;  ///< the coefficient to which those of the candidates are relative
};

/// Computes K, and the loads if the certificate has any, of the structure and compares.
/// @param structure in the load case of the certificate
/// @return otherwise a sentence with the first difference
std::variant<ConsistentStructure, std::string> consistency(const Certificate& certificate,
                                                           const Structure& structure);

}  // namespace kusabi::verify
