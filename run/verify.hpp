// `kusabi verify CERTIFICATE`: proves the list of patterns from the evidence, exactly.
#pragma once

#include <string>

#include "run/session.hpp"

namespace kusabi::run {

struct VerifyOptions {
  std::string certificate;  ///< the file
  bool quiet = false;       ///< no progress, no summary
};

/// Runs the command on all ranks. @return the exit code: `failed` if anything was refused
/// @throws WrongInput on every rank alike, if the file is not a certificate or was altered
int verify(Session& session, const VerifyOptions& options);

}  // namespace kusabi::run
