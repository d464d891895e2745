// All sign patterns of wedged configurations (Algorithms 5.1 and 5.8 of the wedged paper), with
// results for the whole structure: the analysis of `kusabi patterns`.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/relaxation/candidate_bounds.hpp"
#include "nodes/wedged/tree/maximal_cones.hpp"
#include "nodes/wedged/tree/sign_pattern_tree.hpp"
#include "problems/structure/checks/checked_structure.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// The candidates of a block, and its number of maximal cones.
struct PatternBlock {
  support::IndexSet candidates;
  Branching branching = Branching::relative;  ///< branching rule of its tree
  std::uint64_t bound_programs = 0;           ///< solved to bound its candidates before
  std::uint64_t cones = 0;
  std::uint64_t unresolved = 0;  ///< numerically undecided leaves

  [[nodiscard]] bool is_inactive() const { return cones == 0 && unresolved == 0; }
};

/// Verification of every node by the exact test of `kusabi verify` during the search.
enum class Proving {
  automatic,  ///< if floating point may miss a pattern: scale_ratio() is above max_safe_scale_ratio
  always,     ///< for structures of any size
};

/// Purpose and result of the exact test.
struct ExactTest {
  std::optional<double> scale_ratio{};  ///< absent: the search ended before it was computed
  bool asked = false;
  bool done = false;
  std::string unable{};       ///< the reason why a required test was impossible, a sentence
  std::uint64_t refused = 0;  ///< claims that it did not accept
  /// Nodes closed nevertheless, since their subtrees are too large.
  std::uint64_t closed_unproved = 0;
  std::uint64_t unproved = 0;  ///< closed nodes without claim that it does not prove either
  /// Proved for displacements up to this many times the strains only; absent: for all.
  std::optional<double> displacement_ratio{};
  /// Of `rays`: the number of maximal cones, if it proves that they are those found.
  std::optional<std::size_t> cones{};

  /// True if it proves that the list is complete and correct.
  [[nodiscard]] bool proves() const { return done && !is_open() && unproved == 0; }
  /// True if the list may be incomplete although all its patterns are decided.
  [[nodiscard]] bool is_open() const {
    return !unable.empty() || closed_unproved > 0 || (asked && unproved > 0);
  }
};

/// The answer, on rank 0.
struct PatternFindings {
  engine::Outcome<SignPatternTree> outcome;
  /// The maximal cones, then undecided leaves. With a LeafRecorder: without the feasible leaves;
  /// flat cones that a recorded leaf contains are then still here (remove_flat()).
  std::vector<Configuration> leaves;
  /// Those of largest margin, in this order, if the feasible leaves are recorded.
  std::vector<Configuration> largest;
  std::vector<PatternBlock> blocks;
  std::vector<ProvedBound> bounds;  ///< of candidates, on every rank
  /// Of Algorithm 5.8: the leaves to test, in lexicographic order within each block.
  std::vector<PolyhedralLeaf> tested;
  std::size_t flat = 0, marginal = 0, undecided = 0;  ///< among the leaves
  ExactTest exact;

  /// Removes flat leaves, such as those contained in a recorded leaf.
  void remove_flat(const std::function<bool(const Configuration&)>& is_removed);

  [[nodiscard]] bool whole() const { return outcome.status == engine::Status::solved; }

  /// Number of numerically undecided leaves.
  [[nodiscard]] std::size_t unresolved() const { return marginal + undecided; }

  /// True if every pattern is on the list.
  [[nodiscard]] bool is_complete() const { return whole() && unresolved() == 0; }

  /// The number of sign patterns of the whole structure: patterns of different blocks combine
  /// freely.
  [[nodiscard]] support::ExactCount count() const;

  /// The candidates of blocks that cannot wedge, which are always inactive. None if the search
  /// stopped early.
  [[nodiscard]] support::IndexSet inactive() const;
};

/// Options of the analysis.
struct PatternParameters {
  SignPatternOptions tree;
  engine::Options search;     ///< checkpoints, traces, warnings
  EvidenceRecorder recorder;  ///< receives on each rank the evidence of closed nodes; empty: none
  /// Receives on each rank the feasible leaves, which are then not among the findings; empty: none.
  /// Not with `exists`.
  LeafRecorder kept;
  const problems::CheckedStructure* structure = nullptr;  ///< of the problem; null: no exact test
  Proving proving = Proving::automatic;
  bool exists = false;  ///< true: the search ends with the first configuration
};

/// Every rank makes the same call. The findings are complete on rank 0; other ranks have the
/// status.
/// @param friction mu of each contact candidate
/// @throws std::invalid_argument if the sizes do not fit or a number is out of range
PatternFindings find_patterns(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                              std::span<const double> friction,
                              const PatternParameters& parameters = {});

}  // namespace kusabi::wedged
