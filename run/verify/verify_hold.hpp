// `kusabi verify` for certificates of states under load.
#pragma once

#include <optional>
#include <string>

#include "problems/structure/checks/checked_structure.hpp"
#include "run/command/command_run.hpp"
#include "run/verify/verify.hpp"

namespace kusabi::run {

/// Proves all claims, shared among the ranks.
/// @param text of the certificate
/// @throws WrongInput if it is malformed, or there is no problem file
VerifyFindings verify_hold(CommandRun& run, const VerifyOptions& options,
                           const std::optional<problems::CheckedStructure>& structure,
                           const std::string& text);

}  // namespace kusabi::run
