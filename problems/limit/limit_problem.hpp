// Plastic limit analysis of a truss with uncertain dead load (sections 2.2 and 3.1 of the limit
// paper, METR 2006-39):
//
//   lambda*(zeta) = max  lambda
//                   s.t. B q = f_D + T zeta + lambda f_R,   -q^c_i <= q_i <= q^t_i,           (5)
//   lambda_min(alpha) = min { lambda*(zeta) : |zeta_j| <= h_j alpha }.                        (13)
//
// Members may yield at different forces in tension and compression; the paper's common q^y is q^t =
// q^c.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "problems/limit/uncertain_column.hpp"
#include "problems/structure/checks/checked_structure.hpp"
#include "problems/structure/model/structure.hpp"
#include "problems/structure/model/truss.hpp"

namespace kusabi::problems {

struct LimitProblem {
  std::string name;
  int dimension = 0;
  Units units;
  std::vector<std::string> node_names;
  std::vector<Member> members;
  FreeDegrees degrees;                      ///< n^d free displacements
  Eigen::SparseMatrix<double> equilibrium;  ///< B, n^d x n^m
  Eigen::VectorXd dead;                     ///< f_D, n^d, force
  Eigen::VectorXd reference;                ///< f_R, n^d, force; not zero
  /// T: m columns, in the order of axes and nodes of their first components.
  std::vector<UncertainColumn> uncertain;
  Eigen::VectorXd tension;      ///< q^t, n^m, force
  Eigen::VectorXd compression;  ///< q^c, n^m, force
  /// Hash of all of the above except the names.
  std::uint64_t fingerprint = 0;

  int free_count() const { return degrees.size(); }
  int member_count() const { return static_cast<int>(members.size()); }
  int uncertain_count() const { return static_cast<int>(uncertain.size()); }
};

/// Name "a-b" of a member by its nodes.
std::string member_name(const LimitProblem& problem, int member);

/// Name of a column of T, or "x at tip" by its component.
std::string parameter_name(const LimitProblem& problem, int column);

/// True if alpha is a force: every uncertain load is a single component with half-width alpha.
/// Otherwise alpha is a multiple of loads with weights or several components.
bool alpha_is_force(const LimitProblem& problem);

/// f_D + T zeta. @param shares zeta_j / h_j, m
Eigen::VectorXd dead_load(const LimitProblem& problem, const Eigen::VectorXd& shares);

/// Tolerance of f_R^T t_j relative to sum_e |f_R,e t_j,e|: components are typed with about ten
/// digits. No bound and no proof depends on it.
inline constexpr double no_reference_work = 1e-9;

/// True if f_R^T t_j is not zero: such a load changes the reference load, and assumption 3.1 (ii)
/// of the paper does not hold (docs/theory/limit.md).
bool works_with_reference(const LimitProblem& problem, const UncertainColumn& column);

/// Checks the requirements of limit analysis; assumption 3.1 of the paper is not required.
/// @throws InputError if loads or yield forces are missing; if the loads are of several cases; if
///         no reference load acts on a free displacement; if the structure is a mechanism (with the
///         nodes that move)
LimitProblem limit_problem(const CheckedStructure& structure);

}  // namespace kusabi::problems
