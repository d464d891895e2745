// All sign patterns of wedged configurations (Algorithms 5.1 and 5.8 of the wedged paper), and what
// the leaves of the tree say of the structure: the question that `kusabi patterns` asks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/tree/candidate_bounds.hpp"
#include "nodes/wedged/tree/maximal_cones.hpp"
#include "nodes/wedged/tree/sign_pattern.hpp"
#include "problems/structure/model/structure.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// The candidates of a block, and how many maximal cones it has.
struct PatternBlock {
  support::IndexSet candidates;
  Branching branching = Branching::relative;  ///< the rule that its tree was searched by
  std::uint64_t bound_programs = 0;           ///< solved to bound its candidates before
  std::uint64_t cones = 0;
  std::uint64_t open = 0;  ///< leaves of which it could not be told whether they are patterns

  [[nodiscard]] bool rests() const { return cones == 0 && open == 0; }
};

/// Whether every node is put to the exact test of `kusabi verify` while it is searched.
enum class Proving {
  automatic,  ///< where floating point may miss something: scale_ratio() is above wide_scales
  always,     ///< however large the structure is
};

/// Scales of a structure farther apart than this are too far for cut-offs of 1e-10 and 1e-12 of the
/// largest: what they leave out may count.
inline constexpr double wide_scales = 1e7;

/// What is told by its sign then, though it is a tie in sixteen digits.
inline constexpr double finest = 1e-22;

/// What the exact test was for, and what it left.
struct ExactTest {
  double scale_ratio = 1;
  bool asked = false;
  bool done = false;
  std::string unable{};       ///< why it was not done although it should have been, a sentence
  std::uint64_t refused = 0;  ///< claims that it did not accept
  std::uint64_t doubted = 0;  ///< nodes closed all the same, since too much is below them
  std::uint64_t ties = 0;     ///< closed nodes of which nothing is claimed, and it proves nothing

  /// Whether the list is less than what was asked for, though nothing on it is open.
  [[nodiscard]] bool leaves_doubt() const {
    return !unable.empty() || doubted > 0 || (asked && ties > 0);
  }
};

/// The answer, of rank 0.
struct PatternFindings {
  engine::Outcome<SignPatternTree> outcome;
  std::vector<Configuration> leaves;  ///< the maximal cones, then the open leaves
  std::vector<PatternBlock> blocks;
  std::vector<ProvedBound> bounds;  ///< of candidates, on every rank
  /// Of Algorithm 5.8: the leaves to test, block by block in the order of a dictionary.
  std::vector<PolyhedralCandidate> tested;
  std::size_t flat = 0, marginal = 0, undecided = 0;  ///< of the leaves
  ExactTest exact;

  [[nodiscard]] bool whole() const { return outcome.status == engine::Status::solved; }

  /// Leaves of which it could not be told whether they are patterns.
  [[nodiscard]] std::size_t open() const { return marginal + undecided; }

  /// The sign patterns of the whole structure: any of one block goes with any of another.
  [[nodiscard]] support::ExactCount count() const;

  /// The candidates of blocks that cannot wedge: at rest whatever the others do. None if the
  /// search stopped early, since some may come.
  [[nodiscard]] support::IndexSet idle() const;
};

/// What can be chosen beside the problem.
struct PatternQuestion {
  SignPatternOptions tree;
  engine::Options search;  ///< checkpoints, traces, whom to warn
  Witness witness;         ///< told, on each rank, why nodes are closed there; empty: nobody
  const problems::Structure* structure = nullptr;  ///< of the problem; null: no exact test
  Proving proving = Proving::automatic;
  bool exists = false;  ///< only whether there is any: one configuration is enough
};

/// Every rank makes the same call. The findings are whole on rank 0; elsewhere the status counts.
/// @param friction mu of each contact candidate
/// @throws std::invalid_argument if the sizes do not fit or a number is out of range
PatternFindings find_patterns(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                              std::span<const double> friction,
                              const PatternQuestion& question = {});

}  // namespace kusabi::wedged
