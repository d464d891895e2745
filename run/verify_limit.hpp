// `kusabi verify` of a certificate of a worst-case limit load.
#pragma once

#include <string>

#include "run/session.hpp"
#include "run/verify.hpp"

namespace kusabi::run {

/// Proves both ends on all ranks, a node a piece of work, and prints the verdict.
/// @param text of the file, the same on all ranks
/// @return the exit code
/// @throws WrongInput on every rank alike
int verify_limit(Session& session, const VerifyOptions& options, const std::string& text);

}  // namespace kusabi::run
