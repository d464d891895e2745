// Which undecided candidate a node of the tree of sign patterns is split by
// (docs/theory/wedged.md, "Which candidate is branched on").
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "nodes/wedged/tree/contact_solver.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "support/index_set.hpp"

namespace kusabi::wedged {

/// The rule. Any gives the same patterns.
enum class Branching {
  /// What a trial of the others says of large blocks (branching_trial.hpp), `relative` for the
  /// rest and wherever there is no trial.
  automatic,
  /// The largest u_n r_n / c, where c = F_nn + mu |F_nt| is the largest normal displacement that
  /// the candidate's own reaction can bring for each unit of r_n. No unit is left in this product,
  /// and stiff candidates have as much say as soft ones: up to ten times fewer nodes.
  relative,
  /// The largest u_n r_n: Remark 5.5 of the paper.
  product,
  /// The largest product of the distances from the centre of the relaxation to what either sign
  /// leaves of it: both children lose most. A centre costs as much as the bound of the node. On
  /// some faces of meshes sixty times fewer nodes, on others as many times more.
  deepest,
  /// The same product times the root of that of `relative`: mostly near the better of these two.
  weighed,
};

/// A rule for the nodes of one block.
class BranchingRule {
 public:
  /// @param friction of the candidates, m numbers
  BranchingRule(const problems::WedgedProblem& problem, std::span<const double> friction,
                Branching branching);

  /// From now on this rule.
  void set(Branching branching) { branching_ = branching; }

  /// The candidate to split a node by. Of equal ones the first, so that the tree is the same
  /// everywhere.
  /// @param open undecided candidates, not empty  @param solver which has just solved the node
  [[nodiscard]] int candidate(const support::IndexSet& open, ContactSolver& solver) const {
    return best(open, solver, 1).front();
  }

  /// The same and those that come next, the best first: `count` of them, or all there are.
  [[nodiscard]] std::vector<int> best(const support::IndexSet& open, ContactSolver& solver,
                                      int count) const;

  /// The one that violates complementarity most, in the rule's units.
  /// @param violation gives u_n r_n of a candidate
  template <class Violation>
  [[nodiscard]] int most_violated(const support::IndexSet& open, Violation violation) const {
    return largest(open, [&](int i) { return violation(i) * weight(i); });
  }

 private:
  [[nodiscard]] double weight(int candidate) const {
    return branching_ == Branching::product ? 1 : weight_[static_cast<std::size_t>(candidate)];
  }

  template <class Score>
  static int largest(const support::IndexSet& open, Score score) {
    int best = open.lowest();
    double most = -1;
    for (const int i : open) {
      const double own = score(i);
      if (own > most) {
        most = own;
        best = i;
      }
    }
    return best;
  }

  Branching branching_;
  std::vector<double> weight_;  // of u_n r_n by the relative rule: 1 / c
};

}  // namespace kusabi::wedged
