// Sentences that several kinds of certificates share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "problems/structure/checks/checked_structure.hpp"
#include "run/output/wrong_input.hpp"
#include "run/verify/verify.hpp"
#include "support/input_error.hpp"
#include "verify/wedged/certificate.hpp"

namespace kusabi::run {

inline constexpr std::string_view truss_of_certificate =
    "the truss is that of the certificate; with --problem FILE the claim is about a problem file\n";

/// Strengths of the claims after buckling. @param of_file as compared with a problem file
constexpr std::string_view residual_strength(bool of_file) {
  return of_file ? "their residual strength" : "the residual strengths of the certificate";
}

/// The certificate that `read` returns. @throws WrongInput for errors of its text
template <class Read>
auto read_certificate_text(Read read) {
  try {
    return read();
  } catch (const verify::CertificateError& error) {
    throw WrongInput(error.what());
  }
}

/// The certificate as a whole is refused.
VerifyFindings refusal_of_certificate(const VerifyOptions& options, const std::string& why);

/// @param motions number of rigid-body modes of unconstrained bodies
std::string indefinite_stiffness(std::size_t motions);

/// The structure in the load case that a certificate names; nothing if it has no such case.
/// @param load_case empty: the file has no load cases
std::optional<problems::Structure> in_case_of_certificate(const problems::Structure& structure,
                                                          const std::string& load_case);

/// Refusal of a statement about a load case that the problem file does not have.
std::string no_such_case(const VerifyOptions& options, const std::string& load_case);

/// Lines with the load cases that the statements are about, and with those of the file that have no
/// statement; empty if there are no load cases.
std::string covered_cases_text(const std::vector<std::string>& covered);
std::string cases_left_text(const std::vector<std::string>& covered,
                            const problems::Structure& structure);

/// Name, or nothing, and half-width of each uncertain load of a claim.
using HalfWidths = std::vector<std::pair<std::string, double>>;

/// Half-width of all uncertain loads, 0 if there are none; nothing if they differ.
std::optional<double> common_half_width(const HalfWidths& all);

/// The same of all claims of a certificate; nothing if they differ.
std::optional<double> half_width_of_all(const std::vector<HalfWidths>& claims);

/// Line "uncertain loads: wind within +- 5, snow within +- 1, 2 unnamed within +- 30"
std::string half_widths_text(const HalfWidths& all);

/// Problem of a proof about friction: name, file and fingerprint.
std::string verified_problem(const VerifyOptions& options,
                             const problems::CheckedStructure& structure);
std::string verified_friction(const problems::CheckedStructure& structure, double friction);

/// ", 3 of them only for displacements up to 1e+06 times the strains"; empty for none.
std::string large_displacements_text(std::uint64_t nodes);

/// Refusal of a claim for residual strength.
inline constexpr const char* no_struts =
    "the claim is for residual strength, but no member of the problem file has `residual`; "
    "expected the file that was analysed";

/// The fingerprint of a problem; nothing, and the reason in `fault`, if limit analysis does not
/// apply to it, as to a load case without a reference load.
std::optional<std::uint64_t> limit_fingerprint(const problems::CheckedStructure& structure,
                                               std::optional<support::InputError>& fault);

}  // namespace kusabi::run
