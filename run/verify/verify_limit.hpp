// `kusabi verify` for certificates of worst-case limit loads.
#pragma once

#include <optional>
#include <string>

#include "problems/structure/checks/checked_structure.hpp"
#include "run/command/command_run.hpp"
#include "run/verify/verify.hpp"

namespace kusabi::run {

/// Proves both bounds on all ranks, in pieces of one node.
/// @param structure of the problem file to prove it for, if any
/// @param text of the file, the same on all ranks
/// @throws WrongInput on every rank; support::InputError if limit analysis does not apply to the
/// structure
VerifyFindings verify_limit(CommandRun& run, const VerifyOptions& options,
                            const std::optional<problems::CheckedStructure>& structure,
                            const std::string& text);

}  // namespace kusabi::run
