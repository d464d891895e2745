// `kusabi verify` of a certificate of a worst-case limit load.
#pragma once

#include <optional>
#include <string>

#include "problems/structure/model/structure.hpp"
#include "run/command/command_run.hpp"
#include "run/verify/verify.hpp"

namespace kusabi::run {

/// Proves both ends on all ranks, a node a piece of work.
/// @param structure of the problem file that it is to be proved of, if any
/// @param text of the file, the same on all ranks
/// @throws WrongInput on every rank alike; support::InputError if the structure is none that limit
///         analysis is for
VerifyFindings verify_limit(CommandRun& run, const VerifyOptions& options,
                            const std::optional<problems::Structure>& structure,
                            const std::string& text);

}  // namespace kusabi::run
