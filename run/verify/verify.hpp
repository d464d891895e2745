// `kusabi verify CERTIFICATE`: proves the list of patterns from the evidence, exactly.
#pragma once

#include <memory>
#include <string>

#include "run/command/subcommand.hpp"

namespace kusabi::run {

struct VerifyOptions {
  std::string certificate;  ///< the file
  std::string problem;      ///< the problem file it is to be proved of; empty: of its own K
  CheckpointChoice checkpoint;
};

/// What has come of it. The texts are on rank 0.
struct VerifyFindings {
  CertificateCheck check{};
  engine::Status status = engine::Status::solved;  ///< otherwise nothing is said
  std::string refusals = {};                       ///< a line each
  std::string summary = {};                        ///< of what, and how
};

std::unique_ptr<Subcommand> verify_subcommand();

}  // namespace kusabi::run
