// `kusabi verify CERTIFICATE`: proof of a list of patterns or a limit load from a certificate, in
// exact arithmetic.
#pragma once

#include <string>

#include "run/command/subcommand.hpp"

namespace kusabi::run {

struct VerifyOptions {
  std::string certificate;  ///< certificate file
  std::string problem;      ///< problem file to prove it for; empty: the K of the certificate
  CheckpointChoice checkpoint;
};

/// Findings. Texts are on rank 0.
struct VerifyFindings {
  answer::CertificateCheck check{};
  engine::Status status = engine::Status::solved;  ///< not solved: nothing is proved
  std::string refusals = {};                       ///< one line each
  std::string summary = {};                        ///< claims that are proved, and the method
};

}  // namespace kusabi::run
