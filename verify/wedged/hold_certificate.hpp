// Certificate of states under load: trees below which there is none, and states
// (docs/certificates.md). verify/wedged/hold_proof.hpp proves its claims.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "support/index_set.hpp"
#include "verify/wedged/block_proof.hpp"
#include "verify/wedged/certificate.hpp"

namespace kusabi::verify {

/// Beginning of the first line.
inline constexpr std::string_view hold_first_words = "kusabi hold certificate";

/// Restriction of a tree to states whose normal reactions add up to a given sum.
struct GripBound {
  enum class Kind { above, below, equal };  ///< at least, at most, exactly
  Kind kind = Kind::equal;
  double total = 0;  ///< force; of the block

  friend bool operator==(const GripBound&, const GripBound&) = default;
};

/// A tree: no load of the cone of the shares is held in any sign pattern of the block.
struct HoldTree {
  std::size_t line = 0;
  std::size_t block = 0;
  std::vector<LoadShare> shares{};  ///< one or two
  std::optional<GripBound> grip{};
};

/// An infeasible node of a tree.
struct HoldNode {
  std::size_t tree = 0;
  Record record;  ///< its numbers end with the multiplier of the grip, if the tree has one
};

/// A leaf with a state.
struct HoldState {
  std::size_t line = 0;
  std::size_t block = 0;
  std::optional<LoadShare> share{};  ///< nothing: a wedged configuration
  support::IndexSet contact{};
  support::IndexSet separated{};
  std::vector<double> numbers{};
};

/// The content of a file.
struct HoldCertificate {
  std::string load_case;          ///< of the problem file; empty: all loads act
  std::optional<double> total{};  ///< sum of the normal reactions in all its trees and
                                  ///< states, of the only block
  Certificate header;             ///< without stiffness, bounds and records
  std::vector<HoldTree> trees{};
  std::vector<HoldNode> nodes{};
  std::vector<HoldState> states{};
};

/// @throws CertificateError
HoldCertificate read_hold_certificate(std::string_view text, const std::string& file);

}  // namespace kusabi::verify
