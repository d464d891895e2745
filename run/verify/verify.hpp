// `kusabi verify CERTIFICATE`: proves the list of patterns from the evidence, exactly.
#pragma once

#include <string>

#include "run/session/session.hpp"

namespace kusabi::run {

struct VerifyOptions {
  std::string certificate;  ///< the file
  std::string problem;      ///< the problem file it is to be proved of; empty: of its own K
  bool quiet = false;       ///< no progress, no summary
};

/// Runs the command on all ranks.
/// @return the exit code: `failed` if anything was refused, `stopped_early` if the search has left
///         something open that the certificate claims nothing of
/// @throws WrongInput on every rank alike, if the file is not a certificate or was altered;
///         support::InputError if something is wrong with the problem file
int verify(Session& session, const VerifyOptions& options);

}  // namespace kusabi::run
