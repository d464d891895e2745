// Verification of the statements of a certificate of limit loads, one by one.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "engine/outcome.hpp"
#include "problems/structure/checks/checked_structure.hpp"
#include "run/command/command_run.hpp"
#include "run/verify/proof_words.hpp"
#include "run/verify/verify.hpp"
#include "support/input_error.hpp"
#include "verify/limit/limit_certificate.hpp"
#include "verify/limit/limit_consistency.hpp"

namespace kusabi::run {

/// Result for a statement.
struct CheckedStatement {
  verify::LimitClaim claim = verify::LimitClaim::largest;
  bool residual = false;          ///< with all struts at their residual strength
  std::string load_case{};        ///< of the problem file, or of the certificate
  std::uint64_t fingerprint = 0;  ///< of the problem file, if there is one
  HalfWidths half_widths{};
  double lower = 0, upper = 0;  ///< bounds of the load factor in the claim, rounded outwards
  std::size_t cuts = 0, nodes = 0;
  std::vector<std::string> refusals{};  ///< empty: it is proved
};

struct CheckedStatements {
  std::vector<CheckedStatement> statements;
  engine::Status status = engine::Status::solved;  ///< not solved: some were not checked
};

/// The fingerprint of a problem; nothing, and the reason in `fault`, if limit analysis does not
/// apply to it, as to a load case without a reference load.
std::optional<std::uint64_t> limit_fingerprint(const problems::CheckedStructure& structure,
                                               std::optional<support::InputError>& fault);

/// Refusal of a claim for residual strength.
inline constexpr const char* no_struts =
    "the claim is for residual strength, but no member of the problem file has `residual`; "
    "expected the file that was analysed";

/// Proves all statements on all ranks, in pieces of one node.
/// @param structure of the problem file to prove them for, if any
/// @throws support::InputError if limit analysis does not apply to the structure
CheckedStatements check_statements(CommandRun& run, const VerifyOptions& options,
                                   const std::optional<problems::CheckedStructure>& structure,
                                   std::span<const verify::LimitStatement> statements);

}  // namespace kusabi::run
