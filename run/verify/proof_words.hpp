// Sentences that several kinds of certificates share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "problems/structure/checks/checked_structure.hpp"
#include "run/verify/verify.hpp"

namespace kusabi::run {

/// Column of the claims that are proved except for large displacements; the name is also that of
/// saved states of earlier versions.
inline constexpr const char* large_displacements_column = "but for far motion";

inline constexpr std::string_view truss_of_certificate =
    "the truss is that of the certificate; --problem FILE proves the result for a problem file\n";

/// Strengths of the claims after buckling. @param of_file as compared with a problem file
constexpr std::string_view residual_strength(bool of_file) {
  return of_file ? "their residual strength" : "the residual strengths of the certificate";
}

/// The certificate as a whole is refused.
VerifyFindings refusal_of_certificate(const VerifyOptions& options, const std::string& why);

/// @param motions number of rigid-body modes of unconstrained bodies
std::string indefinite_stiffness(std::size_t motions);

/// Problem of a proof about friction: name, file and fingerprint.
std::string verified_problem(const VerifyOptions& options,
                             const problems::CheckedStructure& structure);
std::string verified_friction(const problems::CheckedStructure& structure, double friction);

/// ", 3 of them only for displacements up to 1e+06 times the strains"; empty for none.
std::string large_displacements_text(std::uint64_t nodes);

}  // namespace kusabi::run
