// A mixed zero-one program from end to end, on all ranks: the work at the root, whether it has a
// bound at all, the tree, and what the outcome says of the program.
#pragma once

#include <cstdint>

#include "engine/analysis/analysis.hpp"
#include "nodes/zero_one/root.hpp"
#include "nodes/zero_one/tree.hpp"
#include "solvers/linear/linear_program.hpp"

namespace kusabi::zero_one {

/// An answer is optimal if objective and bound differ by no more than this part of the objective's
/// size (ObjectiveSteps::size). Objectives are told apart in steps of at most 2^-30, or 9.3e-10, of
/// it, and the bound of a whole search is half a step below the objective: ten steps leave room for
/// that and hide nothing.
inline constexpr double optimality_tolerance = 1e-8;

/// What was found out about a program.
enum class MixedStatus {
  optimal,     ///< a point, and no other is better by more than the tolerance
  feasible,    ///< a point; it is not known whether there is a better one
  infeasible,  ///< no point satisfies all rows, bounds and binaries
  unbounded,   ///< points of any objective, however good
  unknown,     ///< no point was found, and it is not known that there is none
};

/// What every rank has before the tree.
struct MixedRoot {
  ZeroOneRoot root;
  /// The objective has no lower bound if there is any point: the root is of the program without
  /// its costs, of which a point is looked for.
  bool unbounded = false;
  /// Some rank was stopped at it (the budget says why): then there is no tree to search.
  bool stopped = false;
};

/// The work at the root, by every rank alike.
/// @param options but for `stop`, which is that of the analysis
/// @throws engine::Disagreement on every rank if they have not come to the same
MixedRoot mixed_root(engine::Analysis& analysis, const linear::MixedProgram& mixed,
                     ZeroOneRootOptions options);

/// The answer; on rank 0, but for the tree. The program is minimised.
struct MixedAnswer {
  ZeroOneTree tree;
  engine::Outcome<ZeroOneTree> outcome;
  bool unbounded = false;

  [[nodiscard]] MixedStatus status() const;
  /// The best one found, or null.
  [[nodiscard]] const ZeroOnePoint* point() const;
  /// No point has a smaller objective.
  [[nodiscard]] double bound() const;
  /// Whether the bound holds in spite of rounding.
  [[nodiscard]] bool proved() const { return tree.proves(); }
  /// Whether the question is answered: not stopped, and nothing left open.
  [[nodiscard]] bool answered() const;
};

/// The tree below the root, searched with Goal::best; or the root's own answer if it was stopped.
/// @param options order, checkpoints and the like
/// @param shown how objectives are shown meanwhile
MixedAnswer search_tree(engine::Analysis& analysis, MixedRoot root, ZeroOneBranching branching,
                        engine::Options options, const engine::ShownObjective& shown);

/// Both.
MixedAnswer solve_mixed(engine::Analysis& analysis, const linear::MixedProgram& mixed,
                        const ZeroOneRootOptions& root_options = {},
                        ZeroOneBranching branching = ZeroOneBranching::paper,
                        const engine::Options& options = {},
                        const engine::ShownObjective& shown = {});

}  // namespace kusabi::zero_one
