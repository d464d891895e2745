// Linear programs of plastic limit analysis: the static principle (5) and the kinematic one (15) of
// the limit paper, without units and with different yield forces in tension and compression, q^t
// and q^c.
//
// All numbers are scaled to the order of one, since a simplex method has one tolerance for all.
// With a typical force F at collapse, a member has the unit c_i = min(F, (q^t + q^c) / 2), the
// equilibrium of displacement e the unit Y_e = max_i |B_ei| c_i, and the reference load the unit R
// = max_e |f_R,e| / Y_e:
//
//   B~ = Y^-1 B C,  f~_D = Y^-1 f_D,  f~_R = Y^-1 f_R / R,  T~ = F Y^-1 T,  q~ = C^-1 q,
//   u~ = R Y u,  lambda~ = R lambda,  zeta~ = zeta / F.
//
// Column j of T~ is a weight w~_j times a direction d~_j whose largest component is of size one.
// The weight includes the half-width, so one alpha applies to all. Units within a factor of eight
// are equal. A yield force far above F stands for an unlimited one; it is truncated at `max_yield`
// c_i, which can only decrease the load factor.
//
// Entries of B and of loads that are rounding errors of cosines are zero in the programs, as a
// simplex method scales them up to the size of all others. They stay in the problem, and so in all
// proofs.
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "problems/limit/limit_problem.hpp"
#include "solvers/linear/linear_program.hpp"

namespace kusabi::problems {

struct LimitModel {
  Eigen::SparseMatrix<double> equilibrium;  ///< B~, n^d x n^m
  Eigen::VectorXd dead;                     ///< f~_D
  Eigen::VectorXd reference;                ///< f~_R: its largest component is of the order of one
  Eigen::VectorXd tension;                  ///< q~^t, at most `max_yield`
  Eigen::VectorXd compression;              ///< q~^c, at most `max_yield`
  std::vector<UncertainColumn> uncertain;   ///< T~; its coefficients zeta are in force_unit
  Eigen::VectorXd direction_unit;           ///< m: d_j is a scaled load d~_j times this, force
  Eigen::VectorXd member_unit;              ///< c, n^m: force is scaled force times this
  Eigen::VectorXd displacement_unit;        ///< 1 / (R Y), n^d: u is u~ times this, f_R^T u = 1
  double force_unit = 1;                    ///< F, force
  double max_yield = 0;                     ///< upper limit of scaled yield forces
  double factor_unit = 1;                   ///< 1 / R: factor is scaled factor times this

  int free_count() const { return static_cast<int>(dead.size()); }
  int member_count() const { return static_cast<int>(tension.size()); }
  int uncertain_count() const { return static_cast<int>(uncertain.size()); }
  /// (q~^t + q~^c) / 2, from 1/8 to `max_yield`, n^m.
  Eigen::VectorXd yield() const { return (tension + compression) / 2; }
  /// Y_e: force is a scaled load on displacement e times this.
  double load_unit(int degree) const { return factor_unit / displacement_unit(degree); }
};

/// Default limit of scaled yield forces; the search increases it if it is active. With the fourteen
/// digits of a simplex method's objective, ten remain.
inline constexpr double default_max_yield = 0x1p14;

/// @param force_unit F
LimitModel limit_model(const LimitProblem& problem, double force_unit,
                       double max_yield = default_max_yield);

/// With the median of the yield forces as F.
LimitModel limit_model(const LimitProblem& problem);

/// Without scaling: all numbers are in the units of the problem, as in its programs. For export
/// only; the search uses scaled models.
LimitModel unscaled_model(const LimitProblem& problem);

/// f_D + T zeta, scaled. @param zeta m, in force_unit
Eigen::VectorXd dead_load(const LimitModel& model, const Eigen::VectorXd& zeta);

/// q, n^m, force, of scaled member forces.
Eigen::VectorXd forces_in_units(const LimitModel& model, const Eigen::VectorXd& forces);

/// u, n^d, with f_R^T u = 1, of a scaled motion.
Eigen::VectorXd motion_in_units(const LimitModel& model, const Eigen::VectorXd& motion);

/// (5): minimise -lambda. Columns: q_1 ... q_nm, lambda. Rows: equilibrium, one for each free
/// displacement; their duals are the collapse mode u with f_R^T u = 1.
linear::LinearProgram static_program(const LimitModel& model, const Eigen::VectorXd& dead);

/// (15), with the same optimum: minimise -(f_D - B (q^t - q^c) / 2)^T u + ((q^t + q^c) / 2)^T z.
/// Different yield forces are reduced to equal ones (q^t + q^c) / 2 by the shift q - (q^t - q^c) /
/// 2. Columns: u_1 ... u_nd, z_1 ... z_nm. Rows: f_R^T u = 1; then z_i - b_i^T u >= 0 and z_i +
/// b_i^T u >= 0 for each member.
linear::LinearProgram kinematic_program(const LimitModel& model, const Eigen::VectorXd& dead);

}  // namespace kusabi::problems
