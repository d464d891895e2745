// `kusabi verify` for lists of patterns: each node is proved in exact arithmetic, on all ranks.
#pragma once

#include <optional>
#include <string>

#include "problems/structure/checks/checked_structure.hpp"
#include "run/command/command_run.hpp"
#include "run/verify/verify.hpp"

namespace kusabi::run {

/// @param structure to prove it for; nothing: the stiffness of the certificate
/// @param text of the certificate
/// @throws WrongInput on every rank if it is not a certificate
VerifyFindings verify_patterns(CommandRun& run, const VerifyOptions& options,
                               const std::optional<problems::CheckedStructure>& structure,
                               const std::string& text);

}  // namespace kusabi::run
