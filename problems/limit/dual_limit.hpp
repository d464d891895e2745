// Dual (45) of the linear relaxation at a node of Algorithm 4.2 of the limit paper, which the paper
// solves instead of (42). The search solves (42): a bounded simplex method has the dual basis
// anyway, and a node's basis is dual feasible at its children. (45) serves tests and comparisons
// with other programs.
//
// Two corrections of the paper's text:
// - (45a) has M rho^+ where the multipliers of (42e) and their right-hand side -M give M zeta^+, as
//   in (48e);
// - (a), (b) (iv) keep row j of (45e) where cuts have coefficients of a fixed tau_j. That row
//   belongs to tau_j as a variable, which it is not: it is dropped, and the cuts' right-hand sides
//   become b - A_tau tau.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "problems/limit/limit_analysis.hpp"
#include "solvers/linear/linear_program.hpp"

namespace kusabi::problems {

/// Value of tau_j fixed at a node: J_0, J_1, or neither.
enum class FixedTau { not_fixed, at_zero, at_one };

/// A row of (42h): terms >= lower, in the columns of worst_case_program().
struct RelaxationCut {
  std::vector<linear::LinearTerm> terms;
  double lower = 0;
};

/// Minimise minus (45a) over (45b) to (45f). Minus its optimum is that of (42) with u and gamma
/// free, if the rows that (a), (b) (ii) call redundant are redundant: |d_j'u| <= M_j / 2 at its
/// optimum for each fixed tau_j. Columns: rho^lambda, q^+ and q^- (n^m each), zeta^+, zeta^-,
/// rho^+, rho^- (m each), mu (one for each cut). Rows: (45b) (n^d), (45c) (n^m), (45d), (45e) (m
/// each). Variables eliminated by (a) and (b) are fixed at zero, and a dropped row has no bounds,
/// such that a basis fits every node.
/// @param alpha scaled
/// @param big_m M, m, scaled as for worst_case_program()
/// @param fixed fixed values, m
linear::LinearProgram dual_program(const LimitModel& model, double alpha,
                                   const Eigen::VectorXd& big_m, std::span<const FixedTau> fixed,
                                   std::span<const RelaxationCut> cuts = {});

}  // namespace kusabi::problems
