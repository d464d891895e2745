// The dual (45) of the linear relaxation at a node of Algorithm 4.2 of the limit paper, which the
// paper solves in place of (42). What is solved here is (42): a simplex method that knows bounds
// has the dual's basis anyway, and a node's basis is dual feasible at its children. (45) is for
// those who want to check a node with another program, and for the tests.
//
// Two places where the paper's text does not hold, and what is meant:
// - (45a) has M rho^+ where the multipliers of (42e) and their right-hand side -M give M zeta^+, as
//   in (48e);
// - (a), (b) (iv) keep row j of (45e) where cuts have coefficients of a tau_j that is held. That
// row
//   belongs to tau_j as a variable, which it is not: it is dropped, and the cuts' right-hand sides
//   become b - A_tau tau.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "problems/limit/limit_analysis.hpp"
#include "solvers/linear/linear_program.hpp"

namespace kusabi::problems {

/// Where a tau_j is held at a node: J_0, J_1, or neither.
enum class HeldTau { not_held, at_zero, at_one };

/// A row of (42h): terms >= lower, its columns being those of worst_case_program().
struct RelaxationCut {
  std::vector<linear::LinearTerm> terms;
  double lower = 0;
};

/// Minimise minus (45a) over (45b) to (45f); minus its optimum is that of (42) with u and gamma
/// free, if the rows that (a), (b) (ii) call redundant are: |d_j'u| <= M_j / 2 at its optimum for
/// each tau_j that is held.
/// Columns: rho^lambda, q^+ and q^- (n^m each), zeta^+, zeta^-, rho^+, rho^- (m each), mu (one a
/// cut). Rows: (45b) (n^d), (45c) (n^m), (45d), (45e) (m each). What (a) and (b) eliminate is held
/// at zero, and a row dropped has no bounds, so that a basis fits every node.
/// @param alpha scaled
/// @param big_m M, m, scaled as for worst_case_program()
/// @param held m
linear::LinearProgram dual_program(const LimitModel& model, double alpha,
                                   const Eigen::VectorXd& big_m, std::span<const HeldTau> held,
                                   std::span<const RelaxationCut> cuts = {});

}  // namespace kusabi::problems
