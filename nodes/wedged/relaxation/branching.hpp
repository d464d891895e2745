// Choice of the undecided candidate by which a node of the tree of sign patterns is split
// (docs/theory/wedged.md, "Branching rules").
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "nodes/wedged/relaxation/contact_solver.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "support/index_set.hpp"

namespace kusabi::wedged {

/// The rule. All rules give the same patterns.
enum class Branching {
  /// The result of sampling for large blocks (tree/branching_trial.hpp), `relative` for all others.
  automatic,
  /// The largest u_n r_n / c, where c = F_nn + mu |F_nt| is the largest normal displacement due to
  /// the candidate's own reaction for each unit of r_n. The product has no unit, and stiff
  /// candidates have the same weight as soft ones: up to ten times fewer nodes.
  relative,
  /// The largest u_n r_n: Remark 5.5 of the paper.
  product,
  /// The largest product of the distances from a point inside the relaxation to the faces of both
  /// signs, where both children lose most. On some faces of meshes in the plane sixty times fewer
  /// nodes, on others as many times more.
  deepest,
  /// The same product times the square root of that of `relative`: mostly close to the better of
  /// these two.
  weighed,
};

/// A rule for the nodes of one block.
class BranchingRule {
 public:
  /// @param friction of the candidates, m numbers
  BranchingRule(const problems::WedgedProblem& problem, std::span<const double> friction,
                Branching branching);

  /// Sets the rule.
  void set(Branching branching) { branching_ = branching; }

  /// The candidate by which a node is split; the first of equal ones, so that the tree is the
  /// same everywhere.
  /// @param undecided undecided candidates, not empty  @param solver with the solution of the node
  [[nodiscard]] int candidate(const support::IndexSet& undecided, ContactSolver& solver) const {
    return best(undecided, solver, 1).front();
  }

  /// The best `count` candidates in order, or all if there are fewer.
  [[nodiscard]] std::vector<int> best(const support::IndexSet& undecided, ContactSolver& solver,
                                      int count) const;

  /// The candidate with the largest violation of complementarity, in the rule's units.
  /// @param violation gives u_n r_n of a candidate
  template <class Violation>
  [[nodiscard]] int most_violated(const support::IndexSet& undecided, Violation violation) const {
    return largest(undecided, [&](int i) { return violation(i) * weight(i); });
  }

 private:
  [[nodiscard]] double weight(int candidate) const {
    return branching_ == Branching::product ? 1 : weight_[static_cast<std::size_t>(candidate)];
  }

  template <class Score>
  static int largest(const support::IndexSet& undecided, Score score) {
    int best = undecided.lowest();
    double maximum = -1;
    for (const int i : undecided) {
      const double own = score(i);
      if (own > maximum) {
        maximum = own;
        best = i;
      }
    }
    return best;
  }

  Branching branching_;
  std::vector<double> weight_;  // factor of u_n r_n in the relative rule: 1 / c
};

}  // namespace kusabi::wedged
