// Solution of a mixed zero-one program on all ranks: the root, a test for unboundedness, the tree,
// and the answer.
#pragma once

#include <cstdint>

#include "engine/analysis/analysis.hpp"
#include "nodes/zero_one/root.hpp"
#include "nodes/zero_one/tree.hpp"
#include "solvers/linear/linear_program.hpp"

namespace kusabi::zero_one {

/// An answer is optimal if objective and bound differ by at most this part of the objective.
/// Objectives are distinguished in steps of at most 2^-30, or 9.3e-10, of their size, and the bound
/// of a complete search is half a step below the objective, so ten steps are sufficient.
inline constexpr double optimality_tolerance = 1e-8;

/// Answer on a program.
enum class MixedStatus {
  optimal,     ///< a point, and no other is better by more than the tolerance
  feasible,    ///< a point, which may not be the best
  infeasible,  ///< no point satisfies all rows, bounds and binaries
  unbounded,   ///< points of arbitrarily small objective
  unknown,     ///< no point was found, and infeasibility is not proved
};

/// Data of every rank before the tree.
struct MixedRoot {
  ZeroOneRoot root;
  /// The objective has no lower bound if there is any point: the root is that of the program
  /// without costs, of which a point is searched.
  bool unbounded = false;
  /// Some rank was stopped at the root (the budget has the reason): there is no tree to search.
  bool stopped = false;
};

/// The root, computed by every rank alike.
/// @param options except `stop`, which is that of the analysis
/// @throws engine::RankMismatch on every rank if their results differ
MixedRoot mixed_root(engine::Analysis& analysis, const linear::MixedProgram& mixed,
                     ZeroOneRootOptions options);

/// The answer, on rank 0 except for the tree. The program is minimised.
struct MixedAnswer {
  ZeroOneTree tree;
  engine::Outcome<ZeroOneTree> outcome;
  bool unbounded = false;

  [[nodiscard]] MixedStatus status() const;
  /// The best point found, or null.
  [[nodiscard]] const ZeroOnePoint* point() const;
  /// Lower bound of the objective.
  [[nodiscard]] double bound() const;
  /// True if the bound holds despite rounding.
  [[nodiscard]] bool proved() const { return tree.proves(); }
  /// True if the answer is complete: not stopped, and nothing left open.
  [[nodiscard]] bool answered() const;
};

/// The tree below the root, searched with Goal::best; or the root's own answer if it was stopped.
/// @param options order, checkpoints and the like
/// @param shown format of objectives in the progress output
MixedAnswer search_tree(engine::Analysis& analysis, MixedRoot root, ZeroOneBranching branching,
                        engine::Options options, const engine::ShownObjective& shown);

/// Root and tree.
MixedAnswer solve_mixed(engine::Analysis& analysis, const linear::MixedProgram& mixed,
                        const ZeroOneRootOptions& root_options = {},
                        ZeroOneBranching branching = ZeroOneBranching::paper,
                        const engine::Options& options = {},
                        const engine::ShownObjective& shown = {});

}  // namespace kusabi::zero_one
