// `kusabi verify CERTIFICATE`: proof of a list of patterns, of held loads, of a limit load or of a
// loss of members from a certificate, in exact arithmetic.
#pragma once

#include <optional>
#include <string>

#include "problems/structure/checks/checked_structure.hpp"
#include "run/command/command_run.hpp"
#include "run/command/subcommand.hpp"

namespace kusabi::run {

struct VerifyOptions {
  std::string certificate;  ///< certificate file
  std::string problem;      ///< problem file to prove it for; empty: the K of the certificate
  CheckpointChoice checkpoint;
};

/// Findings. Texts are on rank 0.
struct VerifyFindings {
  answer::CertificateCheck check{};
  engine::Status status = engine::Status::solved;  ///< not solved: nothing is proved
  std::string refusals = {};                       ///< one line each
  std::string summary = {};                        ///< claims that are proved, and the method
};

/// Proves a certificate about a contact problem, all statements shared among the ranks.
/// @param structure to prove it for; nothing: the stiffness of the certificate
/// @param text of the certificate
/// @throws WrongInput on every rank if it is not a certificate
VerifyFindings verify_contact(CommandRun& run, const VerifyOptions& options,
                              const std::optional<problems::CheckedStructure>& structure,
                              const std::string& text);

/// Proves theorems on load factors of a truss on all ranks, in pieces of one node or state.
/// @param structure of the problem file to prove them for; nothing: the truss of the certificate
/// @param text of the file, the same on all ranks
/// @throws WrongInput on every rank if it is not a certificate; support::InputError if limit
///         analysis does not apply to the structure
VerifyFindings verify_truss(CommandRun& run, const VerifyOptions& options,
                            const std::optional<problems::CheckedStructure>& structure,
                            const std::string& text);

}  // namespace kusabi::run
