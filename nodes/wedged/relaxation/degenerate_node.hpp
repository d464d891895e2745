// Degenerate nodes, t* = 0: their conclusion from the zeros of the relative interior.
#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include "nodes/wedged/relaxation/block_relaxation.hpp"

namespace kusabi::wedged {

/// Conclusion on a node.
struct DegenerateNode {
  enum class Kind {
    infeasible,  ///< no reaction: no configuration, by less than the tolerance
    redundant,   ///< another node has all configurations
    leaf,        ///< all configurations are those of `leaf`
    split,       ///< to be branched at one of `undecided`
    unknown,     ///< the zeros are numerically undecided
  };
  Kind kind = Kind::unknown;
  support::IndexSet undecided{};
  std::optional<Configuration> leaf{};
  Eigen::VectorXd multipliers{};  ///< of the solution before
};

/// Classification of the nodes of a block. A node in which some candidate of U has no reaction is
/// redundant: all its configurations are below the node with that candidate in R. Otherwise it is a
/// leaf if the zeros of its relative interior leave no candidate to be decided.
class DegenerateClassifier {
 public:
  /// @param thorough see SignPatternOptions  @param recorded every pattern is decided by itself
  DegenerateClassifier(conic::Tolerances tolerances, bool thorough, bool recorded)
      : tolerances_(tolerances), thorough_(thorough), recorded_(recorded) {}

  /// True if the solution counts as t* = 0. A sign that no precision level resolves counts as zero,
  /// unless an exact test follows.
  [[nodiscard]] bool is_degenerate(const conic::ConicResult& answer) const;

  /// @param answer of the block's last solution, degenerate  @param iterations are added
  DegenerateNode classify(BlockRelaxation& block, const PatternNode& node,
                          const conic::ConicResult& answer, std::uint64_t& iterations) const;

 private:
  conic::Tolerances tolerances_;
  bool thorough_, recorded_;
};

}  // namespace kusabi::wedged
