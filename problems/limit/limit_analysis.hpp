// The linear programs of plastic limit analysis as data: the static principle (5) and the kinematic
// one (15) of the limit paper, in a form with one yield force a member and without units.
//
// Two changes that lose nothing. Yield forces q^t, q^c in tension and compression are a common one,
// q^y = (q^t + q^c) / 2, of the forces q - (q^t - q^c) / 2, whose equilibrium is with the dead load
// f_D - B (q^t - q^c) / 2. And forces are divided by the largest yield force, f_R by its largest
// component, so that motions with f_R^T u = 1 and forces are both of the order of one.
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "problems/limit/limit_problem.hpp"
#include "solvers/linear/linear_program.hpp"

namespace kusabi::problems {

struct LimitModel {
  Eigen::SparseMatrix<double> equilibrium;  ///< B, n^d x n^m
  Eigen::VectorXd dead;                     ///< f_D, shifted and scaled
  Eigen::VectorXd reference;                ///< f_R, scaled: its largest component is one
  Eigen::VectorXd yield;                    ///< q^y, scaled
  std::vector<UncertainColumn> uncertain;   ///< T; its coefficients zeta are scaled as forces
  Eigen::VectorXd shift;                    ///< (q^t - q^c) / 2, scaled: to be added to q
  double force_unit = 1;                    ///< a scaled force times this is in the user's unit
  double factor_unit = 1;                   ///< a scaled load factor times this is the true one

  int free_count() const { return static_cast<int>(dead.size()); }
  int member_count() const { return static_cast<int>(yield.size()); }
  int uncertain_count() const { return static_cast<int>(uncertain.size()); }
};

LimitModel limit_model(const LimitProblem& problem);

/// f_D + T zeta, scaled. @param zeta m, scaled
Eigen::VectorXd dead_load(const LimitModel& model, const Eigen::VectorXd& zeta);

/// (5): minimise -lambda. Columns: q_1 ... q_nm, lambda. Rows: equilibrium, one a free
/// displacement; the duals of the rows are the collapse mode u with f_R^T u = 1.
LinearProgram static_program(const LimitModel& model, const Eigen::VectorXd& dead);

/// (15), of the same optimum: minimise -f_D^T u + q^y^T z. Columns: u_1 ... u_nd, z_1 ... z_nm.
/// Rows: f_R^T u = 1; then z_i - b_i^T u >= 0 and z_i + b_i^T u >= 0, member by member.
LinearProgram kinematic_program(const LimitModel& model, const Eigen::VectorXd& dead);

/// The value of a motion as the kinematic principle has it, -f_D^T u + q^y^T |B^T u|, over f_R^T u:
/// an upper bound of the load factor. @pre f_R^T u > 0
double kinematic_factor(const LimitModel& model, const Eigen::VectorXd& dead,
                        const Eigen::VectorXd& motion);

}  // namespace kusabi::problems
