// ProofResult: the result of the check of a claim.
#pragma once

#include <optional>
#include <string>

namespace kusabi::verify {

/// A refusal is the predicate or sentence of a message.
struct ProofResult {
  std::optional<std::string> refusal{};     ///< reason why it is not proved; nothing if it is
  bool except_large_displacements = false;  ///< proved for all others only
  /// Of an undecided node: its configurations are proved to be those of nodes with fewer contacts.
  bool unloaded = false;
};

}  // namespace kusabi::verify
