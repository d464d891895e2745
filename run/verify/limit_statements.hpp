// The statements of a certificate of limit loads put to the proof, one by one.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/outcome.hpp"
#include "problems/structure/model/structure.hpp"
#include "run/command/command_run.hpp"
#include "run/verify/verify.hpp"
#include "verify/limit/limit_certificate.hpp"

namespace kusabi::run {

/// What has come of a statement.
struct CheckedStatement {
  verify::LimitClaim claim = verify::LimitClaim::largest;
  std::string load_case{};        ///< of the problem file, or of the certificate without one
  std::uint64_t fingerprint = 0;  ///< of the problem, if there is a problem file
  /// Name, if there is any, and half-width of each uncertain load.
  std::vector<std::pair<std::string, double>> half_widths{};
  double lower = 0, upper = 0;  ///< bounds of the factor of the claim, rounded outwards
  std::size_t cuts = 0, nodes = 0;
  std::vector<std::string> refusals{};  ///< none: it is proved
};

struct CheckedStatements {
  std::vector<CheckedStatement> statements;
  engine::Status status = engine::Status::solved;  ///< otherwise not all were looked at
};

/// Proves all on all ranks, a node a piece of work.
/// @param structure of the problem file that they are to be proved of, if any
/// @throws support::InputError if the structure is none that limit analysis is for
CheckedStatements check_statements(CommandRun& run, const VerifyOptions& options,
                                   const std::optional<problems::Structure>& structure,
                                   std::span<const verify::LimitStatement> statements);

}  // namespace kusabi::run
