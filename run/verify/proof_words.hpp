// Sentences that several kinds of certificates share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "problems/structure/checks/checked_structure.hpp"
#include "run/output/wrong_input.hpp"
#include "run/verify/verify.hpp"
#include "verify/wedged/certificate.hpp"

namespace kusabi::run {

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

/// Problem of a proof about friction: name, file and fingerprint.
std::string verified_problem(const VerifyOptions& options,
                             const problems::CheckedStructure& structure);
std::string verified_friction(const problems::CheckedStructure& structure, double friction);

/// ", 3 of them only for displacements up to 1e+06 times the strains"; empty for none.
std::string large_displacements_text(std::uint64_t nodes);

}  // namespace kusabi::run
