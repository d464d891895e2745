// Relaxation of the nodes of one block: its cone programs, bounds and branching rule.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "nodes/wedged/relaxation/branching.hpp"
#include "nodes/wedged/relaxation/candidate_bounds.hpp"
#include "nodes/wedged/relaxation/contact_solver.hpp"
#include "nodes/wedged/relaxation/facets.hpp"
#include "nodes/wedged/relaxation/mean_motion.hpp"
#include "nodes/wedged/relaxation/pattern_options.hpp"
#include "nodes/wedged/relaxation/sign_pattern.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "support/index_set.hpp"

namespace kusabi::wedged {

struct BlockRelaxation {
  /// @param problem of the block alone  @param within_whole its candidates in the whole
  BlockRelaxation(const problems::WedgedProblem& problem, support::IndexSet within_whole,
                  std::span<const double> friction, const SignPatternOptions& options);

  [[nodiscard]] support::IndexSet free(const SignPattern& node) const {
    return all - (node.contact | node.separated);
  }

  /// A pattern in terms of the whole problem.
  [[nodiscard]] SignPattern in_whole(const SignPattern& own) const;

  /// The last solution as a configuration of a node.
  [[nodiscard]] Configuration configuration(const PatternNode& node, LeafState state,
                                            const conic::ConicResult& answer) const;

  /// Numbers of Evidence::Kind::infeasible. @param multipliers of a solution
  [[nodiscard]] std::vector<double> infeasible_numbers(const Eigen::VectorXd& multipliers) const {
    return mean_motion.with_multipliers(multipliers, solver.unit());
  }
  /// Numbers of Evidence::Kind::feasible.
  [[nodiscard]] std::vector<double> feasible_numbers(const PatternNode& node,
                                                     const Configuration& leaf) const;

  support::IndexSet candidates;  ///< as the whole problem numbers them
  support::IndexSet all;         ///< the same as the block does
  BranchingRule rule;
  ContactSolver solver;
  MeanMotion mean_motion;
  std::vector<CandidateBounds> bounds;  ///< empty: no cuts
  std::optional<FacetBound> outer;      ///< of Algorithm 5.8
};

}  // namespace kusabi::wedged
