// Proof of a certificate of the loss of members, and its claims in words.
#pragma once

#include <optional>
#include <string>

#include "problems/structure/checks/checked_structure.hpp"
#include "run/command/command_run.hpp"
#include "run/verify/verify.hpp"

namespace kusabi::run {

/// @param structure of the problem file to prove the claims for, if any
/// @throws WrongInput for a wrong certificate, on every rank; support::InputError if limit analysis
///         does not apply to the structure
VerifyFindings verify_loss(CommandRun& run, const VerifyOptions& options,
                           const std::optional<problems::CheckedStructure>& structure,
                           const std::string& text);

}  // namespace kusabi::run
