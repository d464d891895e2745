// `kusabi verify` of a list of patterns: each node is proved in exact arithmetic, by all ranks.
#pragma once

#include <optional>
#include <string>

#include "problems/structure/model/structure.hpp"
#include "run/command/command_run.hpp"
#include "run/verify/verify.hpp"

namespace kusabi::run {

/// @param structure that it is to be proved of; nothing: of the certificate's own stiffness
/// @param text of the certificate
/// @throws WrongInput on every rank alike if it is none
VerifyFindings verify_patterns(CommandRun& run, const VerifyOptions& options,
                               const std::optional<problems::Structure>& structure,
                               const std::string& text);

}  // namespace kusabi::run
